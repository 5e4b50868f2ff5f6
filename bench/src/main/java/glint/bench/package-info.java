/** Generators of scenes to measure, and measurements; never part of the product. */
package glint.bench;
