package glint.sampling;

/**
 * A direction close to another one; scratch.
 *
 * <p>Source: T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani and R. Villemin,
 * Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017.
 */
public final class Direction {

  public double x;
  public double y;
  public double z;

  /** Sets this to a multiple of a unit vector and shares of two that are square to it. */
  public void around(double wx, double wy, double wz, double along, double a, double b) {
    double sign = Math.copySign(1, wz);
    double p = -1 / (sign + wz);
    double q = wx * wy * p;
    x = along * wx + a * (1 + sign * wx * wx * p) + b * q;
    y = along * wy + a * sign * q + b * (sign + wy * wy * p);
    z = along * wz - a * sign * wx - b * wy;
  }
}
