package glint.verify;

import glint.geometry.Sphere;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;
import java.util.List;

/**
 * Where a line meets a sphere.
 *
 * <p>With f = o - c exact, D = b² - a(f² - r²), b = f·d, a = d², decides by its sign.
 */
final class SphereOracle implements Oracle {

  /**
   * How far from the silhouette, in u·S with S = |f| + r, the kernel may decide either way.
   *
   * <p>The foot l = f - (b/a)d errs across the ray by u|f| for f, u|f| for the product and u|l| for
   * the difference; its error along the ray, 7u|f|, is square to l and counts only squared. The
   * squares l² and r² add (3/2)u|l| and (1/2)u·r. With |l| near r that is 2u|f| + 3u·r at most.
   */
  static final Bound DECISION = new Bound(4, "u·S");

  /**
   * The largest error of t|d|, in u·S/cos with cos that of ray and normal.
   *
   * <p>h² = r² - l² errs by 2r·4uS, so h by 4uS·r/h = 4uS/cos; b/|d| by 4u|f|, c = f² - r² by 5uf²
   * + 2ur², which the division by q ≥ h leaves below 5uS/cos; a, the sum and the division add at
   * most 3u|q|/|d| ≤ 6uS.
   */
  static final Bound PARAMETER = new Bound(16, "u·S/cos");

  private final Exact3 center;
  private final double radius;

  SphereOracle(Sphere sphere) {
    center = Exact3.of(sphere.center());
    radius = sphere.radius();
  }

  @Override
  public List<Crossing> crossings(Vector3d origin, Vector3d direction) {
    Exact3 d = Exact3.of(direction);
    Exact3 f = Exact3.of(origin).minus(center);
    BigDecimal a = d.squared();
    BigDecimal b = f.dot(d);
    BigDecimal f2 = f.squared();
    BigDecimal r2 = Exact.square(Exact.of(radius));
    BigDecimal discriminant = Exact.square(b).subtract(a.multiply(f2.subtract(r2)));

    double length = Math.sqrt(Exact.toDouble(a));
    double size = Math.sqrt(Exact.toDouble(f2)) + radius;
    double across = Math.sqrt(Exact.toDouble(f2.subtract(Exact.ratio(Exact.square(b), a)).abs()));
    double halfChord2 = Exact.toDouble(discriminant) / (length * length);
    double inside = halfChord2 / ((radius + across) * Rounding.U * size);
    if (discriminant.signum() < 0) {
      BigDecimal nearest = Exact.ratio(b.negate(), a);
      return List.of(new Crossing(nearest, Double.POSITIVE_INFINITY, inside));
    }
    double cos = Math.sqrt(halfChord2) / radius;
    double unit = Rounding.U * size / (cos * length);
    BigDecimal root = Exact.sqrt(discriminant);
    return List.of(
        new Crossing(Exact.ratio(b.negate().subtract(root), a), unit, inside),
        new Crossing(Exact.ratio(b.negate().add(root), a), unit, inside));
  }
}
