package glint.io;

import java.util.Arrays;

/**
 * The corners of a polygon that are not convex, sorted by their places along x and along y, to find
 * the few that are near.
 *
 * <p>If any corner lies in the triangle of three successive ones, one of these does.
 */
final class Blockers {

  private static final int PLACES = 1 << 30;

  private final FlatPolygon polygon;

  /** Whether a corner is not convex and still there. */
  private boolean[] blocks = {};

  private int count;

  private final Sorted byX = new Sorted();
  private final Sorted byY = new Sorted();

  Blockers(FlatPolygon polygon) {
    this.polygon = polygon;
  }

  /** Begins with a new polygon. */
  void begin() {
    int n = polygon.size();
    if (n > blocks.length) {
      blocks = new boolean[Math.max(n, 2 * blocks.length)];
    }
    double[] bounds = polygon.bounds();
    byX.begin(n, bounds[0], bounds[1]);
    byY.begin(n, bounds[2], bounds[3]);
    for (int i = 0; i < n; i++) {
      blocks[i] = polygon.turn(i == 0 ? n - 1 : i - 1, i, i + 1 == n ? 0 : i + 1) <= 0;
      if (blocks[i]) {
        byX.add(i, polygon.x(i));
        byY.add(i, polygon.y(i));
      }
    }
    byX.sort();
    byY.sort();
    count = byX.count;
  }

  boolean blocks(int corner) {
    return blocks[corner];
  }

  void remove(int corner) {
    if (blocks[corner]) {
      blocks[corner] = false;
      count--;
      if (2 * count < byX.count) {
        byX.tidy(blocks);
        byY.tidy(blocks);
      }
    }
  }

  /**
   * Returns whether a corner lies in the triangle of three successive ones, its border included.
   *
   * <p>What coincides with {@code a} or {@code c} does not count: its edges cannot enter the
   * triangle without another corner in it.
   *
   * @param tip whether what coincides with {@code b} counts
   */
  boolean isBlocked(int a, int b, int c, boolean tip) {
    byX.find(polygon.x(a), polygon.x(b), polygon.x(c));
    byY.find(polygon.y(a), polygon.y(b), polygon.y(c));
    Sorted fewest = byX.end - byX.start < byY.end - byY.start ? byX : byY;
    boolean blocked = false;
    int i = fewest.start;
    for (; !blocked && i < fewest.end; i++) {
      int p = (int) fewest.keys[i];
      blocked = blocks[p] && isIn(p, a, b, c, tip);
    }
    polygon.addWork(i - fewest.start);
    return blocked;
  }

  private boolean isIn(int p, int a, int b, int c, boolean tip) {
    if (!byX.spans(polygon.x(p)) || !byY.spans(polygon.y(p))) {
      return false;
    }
    if (polygon.same(p, a) || polygon.same(p, c)) {
      return false;
    }
    if (polygon.same(p, b)) {
      return tip && p != b;
    }
    return polygon.turn(c, a, p) >= 0 && polygon.turn(a, b, p) >= 0 && polygon.turn(b, c, p) >= 0;
  }

  /** Corners in the order of one coordinate. */
  private static final class Sorted {

    /** Place and number of each corner. */
    private long[] keys = {};

    private int count;
    private double least;
    private double perUnit;

    /** The range that was looked for last, and where it was found. */
    private double low;

    private double high;
    private int start;
    private int end;

    void begin(int corners, double from, double to) {
      if (corners > keys.length) {
        keys = new long[Math.max(corners, 2 * keys.length)];
      }
      count = 0;
      least = from;
      perUnit = PLACES / (to - from);
    }

    void add(int corner, double coordinate) {
      keys[count++] = place(coordinate) << 32 | corner;
    }

    void sort() {
      Arrays.sort(keys, 0, count);
    }

    /** Forgets those that do not block any more. */
    void tidy(boolean[] blocks) {
      int kept = 0;
      for (int i = 0; i < count; i++) {
        if (blocks[(int) keys[i]]) {
          keys[kept++] = keys[i];
        }
      }
      count = kept;
    }

    /** Returns a whole number that never falls where the coordinate grows. */
    private long place(double coordinate) {
      return Math.min(PLACES, (long) ((coordinate - least) * perUnit));
    }

    /** Finds all corners whose coordinates lie between those of three. */
    void find(double a, double b, double c) {
      low = Math.min(a, Math.min(b, c));
      high = Math.max(a, Math.max(b, c));
      start = first(place(low));
      end = first(place(high) + 1);
    }

    boolean spans(double coordinate) {
      return low <= coordinate && coordinate <= high;
    }

    private int first(long place) {
      int found = Arrays.binarySearch(keys, 0, count, place << 32);
      return found < 0 ? -1 - found : found;
    }
  }
}
