package glint.sampling;

/**
 * A point of the unit square, as dense as a bilinear function of four weights at its corners;
 * scratch.
 *
 * <p>Where weights follow an integrand, samples have nearly the same worth all over the square.
 * Source: D. Hart, M. Pharr, T. Müller, W. Lopes, M. McGuire and P. Shirley, Practical Product
 * Sampling by Fitting and Composing Warps, Computer Graphics Forum 39(4), 2020.
 */
public final class Bilinear {

  public double u;
  public double v;

  /** How dense points are there, compared with evenly spread ones. */
  public double density;

  /**
   * Finds the point for two numbers of 0 to 1.
   *
   * @param w00 the weight, more than 0, at u = 0, v = 0
   * @param w10 at u = 1, v = 0
   * @param w01 at u = 0, v = 1
   * @param w11 at u = 1, v = 1
   */
  public void at(double first, double second, double w00, double w10, double w01, double w11) {
    v = linear(second, w00 + w10, w01 + w11);
    double left = w00 + v * (w01 - w00);
    double right = w10 + v * (w11 - w10);
    u = linear(first, left, right);
    density = 4 * (left + u * (right - left)) / (w00 + w10 + w01 + w11);
  }

  /** Returns the number below which a share of all lies where density runs from a to b. */
  private static double linear(double share, double a, double b) {
    return share * (a + b) / (a + Math.sqrt(a * a + share * (b * b - a * a)));
  }
}
