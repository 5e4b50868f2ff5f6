package glint.trace;

import glint.geometry.Hit;
import glint.optics.Texel;

/**
 * What a tree of rays has met, in one number; scratch.
 *
 * <p>Two trees of equal signature have met the same faces in the same order, in the light of the
 * same lights, so that radiance changes smoothly between them as far as surfaces are smooth. Where
 * signatures differ, an edge lies between: a silhouette, a shadow, what a mirror shows of them.
 * Different things share a signature by chance once in 2^64.
 */
final class Signature {

  /** Normals that differ by less belong to one flat face. */
  private static final double FACET = 0x1p10;

  /** By how much less a place in an image counts than one met later. */
  private static final double SHARE = 0.4;

  /** The golden ratio in 64 bits. */
  private static final long STEP = 0x9e3779b97f4a7c15L;

  private long value;

  /** Where in its images the tree looks, in their pixels, but for the one it meets first of all. */
  private double x;

  private double y;

  /** Begins with nothing met. */
  void clear() {
    value = 0;
    x = 0;
    y = 0;
  }

  /** Returns the number. */
  long value() {
    return value;
  }

  /** Adds one thing that was met; even what has the number 0 makes a difference to nothing met. */
  void add(long what) {
    long mixed = ((value ^ what) + STEP) * 0xbf58476d1ce4e5b9L;
    value = mixed ^ mixed >>> 29;
  }

  /**
   * Adds what a texture shows: one of the cells of a pattern, or a place in an image. Of several
   * places earlier ones count for less, so that an image and its mirror image do not make up for
   * each other.
   */
  void add(Texel texel) {
    if (texel.isOfImage) {
      x = SHARE * x + texel.x;
      y = SHARE * y + texel.y;
    } else {
      add(texel.cell);
    }
  }

  /** Returns where in its images the tree looks, in their pixels, from left to right. */
  double x() {
    return x;
  }

  /** Returns the same from the bottom to the top. */
  double y() {
    return y;
  }

  /**
   * Adds the face that was hit: of a flat one its surface and normal, of a curved one its surface.
   */
  void add(Hit hit, int surface) {
    add(surface);
    boolean smooth = hit.sx != hit.nx || hit.sy != hit.ny || hit.sz != hit.nz;
    if (!hit.curved && !smooth) {
      add((facet(hit.nx) << 24) + (facet(hit.ny) << 12) + facet(hit.nz));
    }
  }

  /** Returns a component of a unit vector as a whole number of 12 bits. */
  private static long facet(double component) {
    return (int) (component * FACET + (FACET + 0.5));
  }
}
