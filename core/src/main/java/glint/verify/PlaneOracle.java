package glint.verify;

import glint.geometry.Plane;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;
import java.util.List;

/** Where a line meets a plane; the truth is the plane of the rounded unit normal. */
final class PlaneOracle implements Oracle {

  /**
   * How far from the plane's direction (an angle in u) or from its points (in u·S) the kernel may
   * decide either way: n·d and n·(p - o) each err by 3u of their terms, and p - o by u.
   *
   * <p>S = |p - o| + t|d|, the sides of the triangle of origin, hit and anchor.
   */
  static final double DECISION = 6;

  /**
   * The largest error of t|d|, in u·S/cos: those two errors, each term at most √3 of the product.
   */
  static final double PARAMETER = 8;

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
    return List.of(new Crossing(t, Rounding.U * size / (cos * length), cos / Rounding.U));
  }
}
