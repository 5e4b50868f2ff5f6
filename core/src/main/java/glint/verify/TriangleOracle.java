package glint.verify;

import glint.geometry.Triangle;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;
import java.util.List;

/**
 * Where a line meets a triangle: the signs of three edge functions U, V, W, without rounding.
 *
 * <p>Corners relative to the origin are called A, B, C here, S is the largest of their lengths,
 * |A|, |B|, |C| their distances from the line, L the length of an edge as the ray sees it, and det
 * = U + V + W for a unit direction: twice the area as the ray sees it.
 */
final class TriangleOracle implements Oracle {

  /**
   * How far from an edge's line the kernel may decide either way.
   *
   * <p>A sheared corner errs by 6uS an axis, 8.5uS in the plane, and so do edges between corners as
   * they are sheared. Their functions err by 2u|B||C|, and shearing stretches that by 3 at most.
   */
  static final Bound DECISION = new Bound(9, "u(S + |B||C|/L)");

  /**
   * The largest error of t|d|, where cos is that of ray and normal.
   *
   * <p>t is the corners' z at the point that the edge functions mean, Σ eᵢvᵢ / Σ eᵢ. It strays by
   * those 8.5uS and by 18u|A||B||C|/det, and by 1/cos of that along the ray. Summing up and
   * dividing adds 14uS.
   */
  static final Bound PARAMETER = new Bound(23, "u(S + |A||B||C|/det)/cos");

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
    double[] away = new double[3];
    for (int i = 0; i < 3; i++) {
      size = Math.max(size, corners[i].length());
      away[i] = corners[i].cross(d).length() / length;
    }
    double stray = Rounding.U * (size + away[0] * away[1] * away[2] / det);
    double unit = stray * normal.length() / (det * length);
    double inside = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 3; i++) {
      Exact3 p = corners[i];
      Exact3 q = corners[(i + 1) % 3];
      double edge = q.minus(p).cross(d).length() / length;
      double band = Rounding.U * (size + away[i] * away[(i + 1) % 3] / edge);
      double function = along.signum() * Exact.toDouble(p.cross(q).dot(d)) / length;
      inside = Math.min(inside, function / (edge * band));
    }
    // Past a sharp corner the line may be far from the triangle, though near to both its edges.
    if (inside < 0) {
      inside = Math.min(inside, -outside(corners, d, length) / (length * stray));
    }
    double depth = Exact.toDouble(t) / (2 * rejection(corners, direction, det * length));
    return List.of(new Crossing(t, unit, Math.min(inside, DECISION.most() * depth)));
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

  /** The distance of a line that passes outside to the nearest edge or corner, times its length. */
  private static double outside(Exact3[] corners, Exact3 d, double length) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 3; i++) {
      Exact3 p = corners[i];
      Exact3 q = corners[(i + 1) % 3];
      Exact3 edge = q.minus(p).cross(d);
      Exact3 toP = p.cross(d);
      least = Math.min(least, toP.length());
      BigDecimal ahead = toP.dot(edge).negate();
      if (ahead.signum() > 0 && ahead.compareTo(edge.squared()) < 0) {
        double function = Math.abs(Exact.toDouble(p.cross(q).dot(d)));
        least = Math.min(least, function * length / edge.length());
      }
    }
    return least;
  }
}
