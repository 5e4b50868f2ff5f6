package glint.geometry;

import glint.math.BadValueException;

/**
 * What the corners of a mesh's triangles have besides a point, such as a normal: values that
 * corners share; its arrays are never changed once it is made.
 */
public final class CornerValues {

  /** No corner has anything. */
  public static final CornerValues NONE = new CornerValues(1, new double[0], new int[0]);

  private final int width;
  private final double[] values;
  private final int[] indices;

  /**
   * Takes over the two arrays: nobody may change them any more.
   *
   * @param width how many numbers make up a value
   * @param values the numbers of one value after the other
   * @param indices for every corner of every triangle the number of its value, from 0, or -1 if it
   *     has none; empty if no corner has one
   * @throws BadValueException if a number is not finite or an index names no value
   */
  public CornerValues(int width, double[] values, int[] indices) {
    for (double v : values) {
      if (!Double.isFinite(v)) {
        throw new BadValueException("mesh", "must have finite values at its corners, not " + v);
      }
    }
    int count = values.length / width;
    for (int index : indices) {
      if (index < -1 || index >= count) {
        throw new BadValueException(
            "mesh", "has a corner with value " + index + ", but only " + count + " values");
      }
    }
    this.width = width;
    this.values = values;
    this.indices = indices;
  }

  /** Returns whether no corner has a value. */
  public boolean isEmpty() {
    return indices.length == 0;
  }

  /** Returns how many corners this is for; 0 if none has a value. */
  int corners() {
    return indices.length;
  }

  /** Returns whether a corner, three times the triangle's number and 0 to 2, has a value. */
  boolean has(int corner) {
    return indices.length > 0 && indices[corner] >= 0;
  }

  /** Returns the number of a corner's value, or -1. */
  int index(int corner) {
    return indices[corner];
  }

  /** Returns how many values there are. */
  int count() {
    return values.length / width;
  }

  /** Returns one number of a corner that has a value. */
  double of(int corner, int i) {
    return values[width * indices[corner] + i];
  }

  /** Returns one number of a value. */
  double value(int index, int i) {
    return values[width * index + i];
  }

  /** Returns what the arrays take in memory. */
  long bytes() {
    return 8L * values.length + 4L * indices.length;
  }
}
