/** The models of the story scenes. */
package glint.models;
