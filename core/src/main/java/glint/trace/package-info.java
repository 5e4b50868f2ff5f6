/** Whitted's recursion: the radiance that one ray brings back. */
package glint.trace;
