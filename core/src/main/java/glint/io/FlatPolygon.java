package glint.io;

import glint.math.Rounding;
import java.math.BigDecimal;

/** The corners of one polygon after another in a plane, and exact answers about them. */
final class FlatPolygon {

  /** Bounds a determinant's error by a multiple of the sizes of its two products. */
  private static final double BOUND = Rounding.gamma(4);

  /** What an exact decision costs, in comparisons. */
  private static final int EXACTLY = 100;

  private double[] x = {};
  private double[] y = {};
  private int size;
  private long work;

  /** Begins a polygon of so many corners. */
  void begin(int corners) {
    size = corners;
    if (corners > x.length) {
      x = new double[Math.max(corners, 2 * x.length)];
      y = new double[x.length];
    }
  }

  void set(int corner, double cornerX, double cornerY) {
    x[corner] = cornerX;
    y[corner] = cornerY;
  }

  int size() {
    return size;
  }

  double x(int corner) {
    return x[corner];
  }

  double y(int corner) {
    return y[corner];
  }

  boolean same(int a, int b) {
    return x[a] == x[b] && y[a] == y[b];
  }

  /** Returns how many comparisons were made so far, beyond a few for each corner. */
  long work() {
    return work;
  }

  void addWork(long comparisons) {
    work += comparisons;
  }

  /** Returns 1 if three corners run counter-clockwise, -1 if clockwise, 0 if they lie on a line. */
  int turn(int a, int b, int c) {
    double left = (x[a] - x[c]) * (y[b] - y[c]);
    double right = (y[a] - y[c]) * (x[b] - x[c]);
    double det = left - right;
    // What underflow takes away is far less than the least normal number
    double bound = BOUND * (Math.abs(left) + Math.abs(right)) + Double.MIN_NORMAL;
    if (det > bound) {
      return 1;
    }
    if (det < -bound) {
      return -1;
    }
    boolean noLeft = x[a] == x[c] || y[b] == y[c];
    boolean noRight = y[a] == y[c] || x[b] == x[c];
    return noLeft && noRight ? 0 : exactTurn(a, b, c);
  }

  private int exactTurn(int a, int b, int c) {
    work += EXACTLY;
    BigDecimal cx = new BigDecimal(x[c]);
    BigDecimal cy = new BigDecimal(y[c]);
    BigDecimal left = minus(x[a], cx).multiply(minus(y[b], cy));
    BigDecimal right = minus(y[a], cy).multiply(minus(x[b], cx));
    return left.compareTo(right);
  }

  private static BigDecimal minus(double a, BigDecimal b) {
    return new BigDecimal(a).subtract(b);
  }

  /** Returns whether it is convex, turns at every corner and so is divided by a fan. */
  boolean isStrictlyConvex() {
    if (turn(size - 1, 0, 1) <= 0 || turn(size - 2, size - 1, 0) <= 0) {
      return false;
    }
    for (int i = 2; i < size; i++) {
      if (turn(i - 2, i - 1, i) <= 0 || turn(0, i - 1, i) <= 0) {
        return false;
      }
    }
    return true;
  }

  /** Returns the least and the greatest x, then y. */
  double[] bounds() {
    double[] bounds = {x[0], x[0], y[0], y[0]};
    for (int i = 1; i < size; i++) {
      bounds[0] = Math.min(bounds[0], x[i]);
      bounds[1] = Math.max(bounds[1], x[i]);
      bounds[2] = Math.min(bounds[2], y[i]);
      bounds[3] = Math.max(bounds[3], y[i]);
    }
    return bounds;
  }
}
