/** Vectors, quaternions and affine maps: immutable values, and bounds on their rounding. */
package glint.math;
