/** Sources of light. */
package glint.light;
