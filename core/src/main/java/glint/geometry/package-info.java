/** Surfaces as people write them, and the kernels that rays meet them with. */
package glint.geometry;
