/** How materials answer light. */
package glint.optics;
