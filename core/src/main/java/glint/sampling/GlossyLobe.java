package glint.sampling;

/** Directions about another one, as dense as a power of the cosine of the angle to it; scratch. */
public final class GlossyLobe {

  private final Disc disc = new Disc();
  private final Direction way = new Direction();

  /**
   * Finds a direction of density (n + 1)/(2π) cosⁿ α.
   *
   * <p>The points of a disc become directions: the share 1 - cosⁿ⁺¹ α of them lies within α, as ρ²
   * of the points lies within ρ. The middle stays the middle.
   *
   * @param wx the unit direction in the middle
   * @param exponent n, at least 0
   * @param u two numbers of 0 to 1
   */
  public void spread(double wx, double wy, double wz, double exponent, double u, double v) {
    disc.at(u, v);
    double squared = disc.squared();
    if (squared == 0) {
      way.x = wx;
      way.y = wy;
      way.z = wz;
      return;
    }
    double below = -StrictMath.expm1(StrictMath.log1p(-squared) / (exponent + 1));
    double aside = Math.sqrt(below * (2 - below) / squared);
    way.around(wx, wy, wz, 1 - below, aside * disc.a, aside * disc.b);
  }

  public double x() {
    return way.x;
  }

  public double y() {
    return way.y;
  }

  public double z() {
    return way.z;
  }
}
