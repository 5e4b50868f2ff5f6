package glint.verify;

import glint.geometry.Triangle;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;
import java.util.List;

/**
 * Where a line meets a triangle: the signs of three edge functions U, V, W, without rounding.
 *
 * <p>Corners relative to the origin are called A, B, C here, S is the largest of their lengths, R
 * their largest distance from the line, E the extent of the triangle along the line, and det = U +
 * V + W for a unit direction: twice the area as the ray sees it.
 */
final class TriangleOracle implements Oracle {

  /**
   * How far from an edge, in u·S·max(1, R²/det), the kernel may decide either way.
   *
   * <p>A sheared corner errs by 5uS an axis (7uS in the plane), an edge function of the corners as
   * sheared by 2u|B||C|. The first moves an edge by 7uS. The second lets the point that the three
   * functions mean, Σ eᵢ vᵢ / Σ eᵢ, stray by 6u|A||B||C| / det. Shearing stretches by √3 at most.
   */
  static final double DECISION = 24;

  /**
   * The largest error of t|d|, in u·S·(1 + R·E/det).
   *
   * <p>t is a mean of the corners' z, weighted by edge functions that err by 2uR² + 14uSR each; a
   * weight moves the mean by the corner's distance from it, E at most. Summing up adds 10uS.
   */
  static final double PARAMETER = 64;

  private final Exact3 a;
  private final Exact3 b;
  private final Exact3 c;

  TriangleOracle(Triangle triangle) {
    a = Exact3.of(triangle.a());
    b = Exact3.of(triangle.b());
    c = Exact3.of(triangle.c());
  }

  @Override
  public List<Crossing> crossings(Vector3d origin, Vector3d direction) {
    Exact3 o = Exact3.of(origin);
    Exact3 d = Exact3.of(direction);
    Exact3[] corners = {a.minus(o), b.minus(o), c.minus(o)};
    Exact3 normal = b.minus(a).cross(c.minus(a));
    BigDecimal along = normal.dot(d);
    if (along.signum() == 0) {
      return List.of();
    }
    BigDecimal t = Exact.ratio(normal.dot(corners[0]), along);

    double length = d.length();
    double det = Math.abs(Exact.toDouble(along)) / length;
    double size = 0;
    double reach = 0;
    double nearest = Double.POSITIVE_INFINITY;
    double farthest = Double.NEGATIVE_INFINITY;
    for (Exact3 v : corners) {
      size = Math.max(size, v.length());
      reach = Math.max(reach, v.cross(d).length() / length);
      double z = Exact.toDouble(v.dot(d)) / length;
      nearest = Math.min(nearest, z);
      farthest = Math.max(farthest, z);
    }
    double unit = Rounding.U * size * (1 + reach * (farthest - nearest) / det) / length;
    double band = Rounding.U * size * Math.max(1, reach * reach / det);
    double inside = distance(corners, d, along.signum()) / (length * band);
    double depth = Exact.toDouble(t) / (2 * rejection(corners, direction, det * length));
    return List.of(new Crossing(t, unit, Math.min(inside, DECISION * depth)));
  }

  /**
   * Returns pbrt's bound on the error of t, from which on a hit counts as one before the origin:
   * 3uZ(36XY + 10Z(X + Y))/det in sheared coordinates (Pharr, Jakob, Humphreys, 3rd ed., 3.9.6).
   *
   * @param normalDot the triangle's normal, as long as twice its area, times the direction
   */
  private static double rejection(Exact3[] corners, Vector3d d, double normalDot) {
    double x = 0;
    double y = 0;
    double z = 0;
    for (Exact3 corner : corners) {
      Vector3d v = inOrder(corner.toDoubles(), d);
      Vector3d e = inOrder(d, d);
      x = Math.max(x, Math.abs(v.x() - e.x() / e.z() * v.z()));
      y = Math.max(y, Math.abs(v.y() - e.y() / e.z() * v.z()));
      z = Math.max(z, Math.abs(v.z()));
    }
    return 3 * Rounding.U * z * (36 * x * y + 10 * z * (x + y)) / normalDot;
  }

  /** Turns a vector so that the largest component of the direction comes last. */
  private static Vector3d inOrder(Vector3d v, Vector3d d) {
    if (Math.abs(d.z()) == d.maxAbs()) {
      return v;
    }
    return Math.abs(d.y()) == d.maxAbs()
        ? new Vector3d(v.z(), v.x(), v.y())
        : new Vector3d(v.y(), v.z(), v.x());
  }

  /**
   * The distance of the line to the nearest edge, below 0 outside, times the direction's length.
   */
  private static double distance(Exact3[] corners, Exact3 d, int winding) {
    double least = Double.POSITIVE_INFINITY;
    double outside = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 3; i++) {
      Exact3 p = corners[i];
      Exact3 q = corners[(i + 1) % 3];
      Exact3 edge = q.minus(p).cross(d);
      Exact3 toP = p.cross(d);
      // The edge function is positive on the inner side; length twice for d and the edge's.
      double function = winding * Exact.toDouble(p.cross(q).dot(d)) / edge.length();
      double toLine = function * d.length();
      least = Math.min(least, toLine);
      BigDecimal ahead = toP.dot(edge).negate();
      boolean between = ahead.signum() >= 0 && ahead.compareTo(edge.squared()) <= 0;
      double toEnds = Math.min(toP.length(), q.cross(d).length());
      outside = Math.min(outside, between ? Math.abs(toLine) : toEnds);
    }
    return least >= 0 ? least : -outside;
  }
}
