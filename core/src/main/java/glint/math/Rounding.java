package glint.math;

/**
 * Bounds on the rounding error of IEEE double arithmetic, from which every tolerance is derived.
 *
 * <p>Source: N. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 3.1.
 */
public final class Rounding {

  /** The unit roundoff 2^-53: one operation errs by at most this, relatively. */
  public static final double U = 0x1p-53;

  /** Multiplied by this, a number parts into halves whose products are exact. */
  private static final double SPLIT = 0x1p27 + 1;

  private Rounding() {}

  /** Returns γ(n) = nu / (1 - nu), the bound on the relative error of n operations in a row. */
  public static double gamma(int n) {
    return n * U / (1 - n * U);
  }

  /** Returns what {@code x * x} lacks of the square of a number of -1 to 1 (Dekker 1971). */
  public static double ofSquare(double x) {
    double high = x * SPLIT - (x * SPLIT - x);
    double low = x - high;
    return high * high - x * x + 2 * high * low + low * low;
  }
}
