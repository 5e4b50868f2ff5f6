package glint.sampling;

/**
 * A point of the unit disc, evenly spread where a pair of numbers is; scratch.
 *
 * <p>Squares about the middle become circles, so that what is well spread stays so, and the middle
 * stays the middle. Source: P. Shirley and K. Chiu, A Low Distortion Map Between Disk and Square,
 * Journal of Graphics Tools 2(3), 1997.
 */
public final class Disc {

  private static final double EIGHTH = Math.PI / 4;

  public double a;
  public double b;

  /** Finds the point for two numbers of 0 to 1. */
  public void at(double u, double v) {
    double x = 2 * u - 1;
    double y = 2 * v - 1;
    if (x == 0 && y == 0) {
      a = 0;
      b = 0;
    } else if (Math.abs(x) > Math.abs(y)) {
      double angle = EIGHTH * (y / x);
      a = x * StrictMath.cos(angle);
      b = x * StrictMath.sin(angle);
    } else {
      double angle = EIGHTH * (x / y);
      a = y * StrictMath.sin(angle);
      b = y * StrictMath.cos(angle);
    }
  }

  /** Returns the square of the point's distance from the middle, below 1. */
  public double squared() {
    return a * a + b * b;
  }
}
