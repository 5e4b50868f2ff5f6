package glint.io;

import glint.geometry.CornerValues;

/** Normals or texture points of a model while it is read, and which corners have them. */
final class ObjCorners {

  private final int width;
  private final Doubles values = new Doubles();

  /** One a corner, -1 for none; what is not written yet has none. */
  private final Ints indices = new Ints();

  /**
   * Makes it empty.
   *
   * @param width how many numbers make up a value
   */
  ObjCorners(int width) {
    this.width = width;
  }

  /** Adds a value: as many of the three numbers as make it up. */
  void add(double[] three) {
    for (int i = 0; i < width; i++) {
      values.add(three[i]);
    }
  }

  int count() {
    return values.size() / width;
  }

  /** Gives its three corners of a triangle their values, by number from 0, or -1. */
  void triangle(int number, int a, int b, int c) {
    if (Math.max(a, Math.max(b, c)) >= 0) {
      indices.fill(3 * number, -1);
      indices.add(a);
      indices.add(b);
      indices.add(c);
    }
  }

  /** Returns the values of so many corners; ends the use of this. */
  CornerValues values(int corners) {
    if (indices.size() == 0) {
      return CornerValues.NONE;
    }
    indices.fill(corners, -1);
    return new CornerValues(width, values.toArray(), indices.toArray());
  }
}
