package glint.verify;

import glint.geometry.Plane;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;
import java.util.List;

/** Where a line meets a plane; the truth is the plane of the rounded unit normal. */
final class PlaneOracle implements Oracle {

  /**
   * How far from the plane's direction (an angle in u) or from its points (in u·S, S being |p - o|
   * + t|d|) the kernel may decide either way: n·d and n·(p - o) err by 3u, and p - o by u.
   */
  static final Bound DECISION = new Bound(4, "u·S");

  /**
   * The largest error of t|d|, in u·S/cos: 4u|p - o| and 4ut|d|, and one more for products of
   * errors. The cosine is less its own error, 3u.
   */
  static final Bound PARAMETER = new Bound(5, "u·S/cos");

  private final Exact3 point;
  private final Exact3 normal;

  PlaneOracle(Plane plane) {
    point = Exact3.of(plane.point());
    normal = Exact3.of(plane.normal().normalized());
  }

  @Override
  public List<Crossing> crossings(Vector3d origin, Vector3d direction) {
    Exact3 d = Exact3.of(direction);
    Exact3 toPoint = point.minus(Exact3.of(origin));
    BigDecimal along = normal.dot(d);
    if (along.signum() == 0) {
      return List.of(new Crossing(BigDecimal.ONE.negate(), Double.POSITIVE_INFINITY, 0));
    }
    BigDecimal t = Exact.ratio(normal.dot(toPoint), along);
    double length = d.length();
    double cos = Math.abs(Exact.toDouble(along)) / length;
    double size = toPoint.length() + Math.abs(Exact.toDouble(t)) * length;
    double sure = Math.max(0, cos - 3 * Rounding.U);
    return List.of(new Crossing(t, Rounding.U * size / (sure * length), cos / Rounding.U));
  }
}
