package glint.math;

/**
 * Bounds on the rounding error of IEEE double arithmetic, from which every tolerance is derived.
 *
 * <p>Source: N. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 3.1.
 */
public final class Rounding {

  /** The unit roundoff 2^-53: one operation errs by at most this, relatively. */
  public static final double U = 0x1p-53;

  private Rounding() {}

  /** Returns γ(n) = nu / (1 - nu), the bound on the relative error of n operations in a row. */
  public static double gamma(int n) {
    return n * U / (1 - n * U);
  }
}
