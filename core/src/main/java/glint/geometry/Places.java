package glint.geometry;

import java.util.Arrays;

/** Finds points of a mesh that stand at the same place, to the last bit. */
final class Places {

  private final double[] points;

  /** An open hash table of the numbers of points, -1 where it is empty. */
  private final int[] table;

  private Places(double[] points) {
    this.points = points;
    table = new int[Integer.highestOneBit(points.length / 3 + 1) << 2];
    Arrays.fill(table, -1);
  }

  /** Returns for every point the number of the first one at its place. */
  static int[] of(double[] points) {
    Places places = new Places(points);
    int[] first = new int[points.length / 3];
    for (int i = 0; i < first.length; i++) {
      first[i] = places.firstAt(i);
    }
    return first;
  }

  private int firstAt(int point) {
    int slot = hash(point) & table.length - 1;
    while (table[slot] >= 0 && !isSame(table[slot], point)) {
      slot = slot + 1 & table.length - 1;
    }
    if (table[slot] < 0) {
      table[slot] = point;
    }
    return table[slot];
  }

  private int hash(int point) {
    long h = 0;
    for (int axis = 0; axis < 3; axis++) {
      // Adding zero makes one zero of both.
      h = (h ^ Double.doubleToRawLongBits(points[3 * point + axis] + 0.0)) * 0x9E3779B97F4A7C15L;
      h ^= h >>> 32;
    }
    return (int) h;
  }

  private boolean isSame(int a, int b) {
    return points[3 * a] == points[3 * b]
        && points[3 * a + 1] == points[3 * b + 1]
        && points[3 * a + 2] == points[3 * b + 2];
  }
}
