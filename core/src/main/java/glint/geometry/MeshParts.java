package glint.geometry;

import java.util.Arrays;

/**
 * Which part of a mesh each triangle belongs to, as runs of triangles of one part; its arrays are
 * never changed once it is made.
 */
final class MeshParts {

  /** Everything is of one part. */
  static final MeshParts ONE = new MeshParts(new int[] {0}, new int[] {0});

  private final int[] starts;
  private final int[] parts;
  private final int count;

  /**
   * Takes over the two arrays.
   *
   * @param starts the first triangle of each run: 0, and then ever higher ones
   * @param parts the part of each run, from 0
   */
  MeshParts(int[] starts, int[] parts) {
    if (starts.length == 0 || starts[0] != 0 || starts.length != parts.length) {
      throw new IllegalArgumentException("the first of all triangles needs a part");
    }
    int most = 0;
    for (int i = 0; i < parts.length; i++) {
      if (parts[i] < 0 || (i > 0 && starts[i] <= starts[i - 1])) {
        throw new IllegalArgumentException("runs of triangles come in order, parts from 0");
      }
      most = Math.max(most, parts[i]);
    }
    this.starts = starts;
    this.parts = parts;
    count = most + 1;
  }

  /** Returns the number of parts, at least 1. */
  int count() {
    return count;
  }

  /** Returns the part of a triangle. */
  int of(int triangle) {
    int found = Arrays.binarySearch(starts, triangle);
    return parts[found >= 0 ? found : -found - 2];
  }
}
