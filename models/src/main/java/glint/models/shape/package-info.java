/** Modelling: surfaces of polygons, and the ways to make them. */
package glint.models.shape;
