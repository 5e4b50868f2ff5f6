package glint.io;

import java.math.BigDecimal;

/** Polygons of the plane for tests: x and y of each corner. */
final class Polygons {

  private Polygons() {}

  /** The shoelace formula without any rounding. */
  static BigDecimal twiceArea(double... xy) {
    BigDecimal sum = BigDecimal.ZERO;
    for (int i = 0; i < xy.length; i += 2) {
      int j = (i + 2) % xy.length;
      BigDecimal left = new BigDecimal(xy[i]).multiply(new BigDecimal(xy[j + 1]));
      sum = sum.add(left).subtract(new BigDecimal(xy[j]).multiply(new BigDecimal(xy[i + 1])));
    }
    return sum;
  }

  static double[] reversed(double[] xy) {
    double[] r = new double[xy.length];
    for (int i = 0; i < xy.length; i += 2) {
      r[xy.length - 2 - i] = xy[i];
      r[xy.length - 1 - i] = xy[i + 1];
    }
    return r;
  }

  /** Turns the part between two crossing edges round, which makes the way around shorter. */
  static void untangle(double[] xy) {
    int n = xy.length / 2;
    for (int tries = 0; tries < 100; tries++) {
      for (int i = 0; i < n; i++) {
        for (int j = i + 2; j < n; j++) {
          if (meet(xy, i, j)) {
            for (int a = i + 1, b = j; a < b; a++, b--) {
              swap(xy, 2 * a, 2 * b);
              swap(xy, 2 * a + 1, 2 * b + 1);
            }
          }
        }
      }
    }
  }

  private static void swap(double[] xy, int a, int b) {
    double kept = xy[a];
    xy[a] = xy[b];
    xy[b] = kept;
  }

  /** Whether no edge meets another one but its neighbours at their common corners. */
  static boolean isSimple(double[] xy) {
    int n = xy.length / 2;
    for (int i = 0; i < n; i++) {
      int k = (i + 1) % n;
      int l = (i + 2) % n;
      boolean turnsBack = turn(xy, i, k, l) == 0 && !isBetween(xy, i, k, l);
      if (turnsBack || xy[2 * i] == xy[2 * k] && xy[2 * i + 1] == xy[2 * k + 1]) {
        return false;
      }
      for (int j = i + 2; j < n && !(i == 0 && j == n - 1); j++) {
        if (meet(xy, i, j)) {
          return false;
        }
      }
    }
    return true;
  }

  private static boolean meet(double[] xy, int i, int j) {
    int n = xy.length / 2;
    int k = (i + 1) % n;
    int l = (j + 1) % n;
    if (k == j || l == i) {
      return false;
    }
    int a = turn(xy, i, k, j);
    int b = turn(xy, i, k, l);
    int c = turn(xy, j, l, i);
    int d = turn(xy, j, l, k);
    if (a * b < 0 && c * d < 0) {
      return true;
    }
    return a == 0 && isBetween(xy, i, j, k)
        || b == 0 && isBetween(xy, i, l, k)
        || c == 0 && isBetween(xy, j, i, l)
        || d == 0 && isBetween(xy, j, k, l);
  }

  /** Exact for the multiples of powers of two that the random tests use. */
  private static int turn(double[] xy, int a, int b, int c) {
    double left = (xy[2 * a] - xy[2 * c]) * (xy[2 * b + 1] - xy[2 * c + 1]);
    return (int) Math.signum(left - (xy[2 * a + 1] - xy[2 * c + 1]) * (xy[2 * b] - xy[2 * c]));
  }

  /** Whether b, on the line of a and c, lies between them. */
  private static boolean isBetween(double[] xy, int a, int b, int c) {
    double x = (xy[2 * b] - xy[2 * a]) * (xy[2 * b] - xy[2 * c]);
    double y = (xy[2 * b + 1] - xy[2 * a + 1]) * (xy[2 * b + 1] - xy[2 * c + 1]);
    return x <= 0 && y <= 0;
  }
}
