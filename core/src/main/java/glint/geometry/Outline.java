package glint.geometry;

import glint.math.Transform;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/** Points whose convex hull holds a convex surface, to find out where in an image it may be. */
public final class Outline {

  /** Corners around a circle: the polygon is 1/cos(π/16) times as wide. */
  private static final int AROUND = 16;

  private static final double WIDER = 1 / StrictMath.cos(StrictMath.PI / AROUND);

  /** Where they are on a circle of radius 1. */
  private static final double[] COS = new double[AROUND];

  private static final double[] SIN = new double[AROUND];

  static {
    for (int i = 0; i < AROUND; i++) {
      double angle = StrictMath.PI * (2 * i + 1) / AROUND;
      COS[i] = StrictMath.cos(angle);
      SIN[i] = StrictMath.sin(angle);
    }
  }

  private Outline() {}

  /**
   * Returns the points, in the world.
   *
   * <p>For round things they hold what is seen of them from the eye, and up to 2 % more.
   *
   * @param eye from where it is seen, in the world
   * @return none for planes, which have no end, and for meshes, which need not be convex
   */
  public static List<Vector3d> of(Surface shape, Transform toWorld, Vector3d eye) {
    List<Vector3d> points = new ArrayList<>();
    if (shape instanceof Sphere s) {
      sphere(s, toWorld.inverted().point(eye), points);
    } else if (shape instanceof Triangle t) {
      points.addAll(List.of(t.a(), t.b(), t.c()));
    } else if (shape instanceof Quad q) {
      Vector3d b = q.corner().plus(q.edge1());
      Vector3d d = q.corner().plus(q.edge2());
      points.addAll(List.of(q.corner(), b, b.plus(q.edge2()), d));
    } else if (shape instanceof Box b) {
      for (int i = 0; i < 8; i++) {
        Vector3d p = (i & 1) == 0 ? b.min() : b.max();
        Vector3d q = (i & 2) == 0 ? b.min() : b.max();
        Vector3d r = (i & 4) == 0 ? b.min() : b.max();
        points.add(new Vector3d(p.x(), q.y(), r.z()));
      }
    } else if (shape instanceof Pyramid p) {
      points.add(p.apex());
      points.addAll(p.base());
    } else if (shape instanceof Cylinder c) {
      Vector3d axis = c.top().minus(c.base());
      Vector3d across = axis.normalized().cross(toWorld.inverted().point(eye).minus(c.base()));
      circle(c.base(), axis, across, c.radius(), points);
      circle(c.top(), axis, across, c.topRadius(), points);
    }
    points.replaceAll(toWorld::point);
    return points;
  }

  /** Adds a polygon around the circle in which the lines of sight touch a sphere. */
  private static void sphere(Sphere s, Vector3d eye, List<Vector3d> points) {
    Vector3d toEye = eye.minus(s.center());
    double nearness = s.radius() / toEye.length();
    if (nearness < 1) {
      Vector3d middle = s.center().plus(toEye.times(nearness * nearness));
      double radius = s.radius() * Math.sqrt(1 - nearness * nearness);
      circle(middle, toEye, Vector3d.ZERO, radius, points);
    }
  }

  /**
   * Adds a polygon around a circle.
   *
   * @param to in which direction, square to the axis, it shall not be wider; any if zero
   */
  private static void circle(
      Vector3d middle, Vector3d axis, Vector3d to, double radius, List<Vector3d> points) {
    Vector3d n = axis.normalized();
    boolean upright = Math.abs(n.z()) > Math.abs(n.x());
    Vector3d any = n.cross(upright ? new Vector3d(1, 0, 0) : new Vector3d(0, 0, 1));
    Vector3d u = (to.maxAbs() > 0 ? to : any).normalized();
    Vector3d v = n.cross(u);
    for (int i = 0; i < AROUND; i++) {
      double x = WIDER * radius * COS[i];
      double y = WIDER * radius * SIN[i];
      points.add(middle.plus(u.times(x)).plus(v.times(y)));
    }
  }
}
