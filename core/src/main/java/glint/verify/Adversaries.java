package glint.verify;

import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.geometry.Triangle;
import glint.math.Vector3d;
import glint.verify.Adversary.Spot;
import java.util.List;

/** The adversary of every kind of primitive: mixed scales, slivers, tangents, edges and corners. */
final class Adversaries {

  static final List<Adversary<?>> ALL =
      List.of(
          new Adversary<>(
              "sphere",
              Adversaries::sphere,
              SphereOracle::new,
              Adversaries::onSphere,
              SphereOracle.DECISION,
              SphereOracle.PARAMETER),
          new Adversary<>(
              "triangle",
              Adversaries::triangle,
              TriangleOracle::new,
              Adversaries::onTriangle,
              TriangleOracle.DECISION,
              TriangleOracle.PARAMETER),
          new Adversary<>(
              "plane",
              Adversaries::plane,
              PlaneOracle::new,
              Adversaries::onPlane,
              PlaneOracle.DECISION,
              PlaneOracle.PARAMETER),
          new Adversary<>(
              "box",
              Adversaries::box,
              BoxOracle::new,
              Adversaries::onBox,
              BoxOracle.DECISION,
              BoxOracle.PARAMETER),
          new Adversary<>(
              "cylinder",
              dice -> cylinder(dice, 1),
              CylinderOracle::new,
              Adversaries::onCylinder,
              CylinderOracle.DECISION,
              CylinderOracle.PARAMETER),
          new Adversary<>(
              "cone",
              dice -> cylinder(dice, dice.below(2) == 0 ? 0 : dice.log(1e-3, 1e3)),
              CylinderOracle::new,
              Adversaries::onCylinder,
              CylinderOracle.DECISION,
              CylinderOracle.PARAMETER));

  private Adversaries() {}

  private static Sphere sphere(Dice dice) {
    double r = dice.log(1e-6, 1e6);
    return new Sphere(dice.cube(r * dice.log(1e-3, 1e8)), r);
  }

  private static Spot onSphere(Dice dice, Sphere s) {
    Vector3d n = dice.unit();
    return new Spot(s.center().plus(n.times(s.radius())), graze(dice, n, 1e-9), s.radius());
  }

  /** A triangle with sides of a ratio up to 1e8, anywhere. */
  private static Triangle triangle(Dice dice) {
    double length = dice.log(1e-6, 1e6);
    Vector3d a = dice.cube(length * dice.log(1e-3, 1e6));
    Vector3d side = dice.unit().times(length);
    Vector3d width = dice.across(side).times(length / dice.log(1, 1e8));
    return new Triangle(a, a.plus(side), a.plus(side.times(dice.in(-1, 2))).plus(width));
  }

  private static Spot onTriangle(Dice dice, Triangle t) {
    Vector3d p = t.b().minus(t.a());
    Vector3d q = t.c().minus(t.a());
    double u = dice.below(3) == 0 ? 0 : dice.in(0, 1);
    double v = dice.below(3) == 0 ? 0 : dice.in(0, 1 - u);
    v = dice.below(3) == 0 ? 1 - u : v;
    Vector3d n = p.cross(q);
    Vector3d at = t.a().plus(p.times(u)).plus(q.times(v));
    Vector3d square = n.maxAbs() > 0 ? n.normalized() : dice.across(p);
    return new Spot(at, graze(dice, square, 1e-9), Math.max(p.maxAbs(), q.maxAbs()));
  }

  private static Plane plane(Dice dice) {
    return new Plane(dice.cube(dice.log(1e-6, 1e6)), axis(dice).times(dice.log(1e-6, 1e6)));
  }

  private static Spot onPlane(Dice dice, Plane p) {
    double size = dice.log(1e-6, 1e6);
    Vector3d n = p.normal().normalized();
    return new Spot(p.point().plus(dice.across(n).times(size)), graze(dice, n, 1e-17), size);
  }

  private static Box box(Dice dice) {
    double size = dice.log(1e-6, 1e6);
    Vector3d min = dice.cube(size * dice.log(1e-3, 1e6));
    while (true) {
      double thin = dice.log(1e-6, 1);
      Vector3d edges = new Vector3d(1, thin, dice.in(thin, 1)).times(size);
      edges = dice.below(2) == 0 ? new Vector3d(edges.z(), edges.x(), edges.y()) : edges;
      Vector3d max = min.plus(edges);
      if (max.x() > min.x() && max.y() > min.y() && max.z() > min.z()) {
        return new Box(min, max);
      }
    }
  }

  /** A corner, or a point of an edge or face, or inside; half of the rays run along faces. */
  private static Spot onBox(Dice dice, Box b) {
    Vector3d p =
        new Vector3d(
            between(dice, b.min().x(), b.max().x()),
            between(dice, b.min().y(), b.max().y()),
            between(dice, b.min().z(), b.max().z()));
    return new Spot(p, axis(dice), b.max().minus(b.min()).maxAbs());
  }

  private static double between(Dice dice, double least, double greatest) {
    return switch (dice.below(3)) {
      case 0 -> least;
      case 1 -> greatest;
      default -> Math.min(greatest, Math.max(least, dice.in(least, greatest)));
    };
  }

  /** Any direction, one within a coordinate plane, or one along an axis. */
  private static Vector3d axis(Dice dice) {
    Vector3d v = dice.unit();
    Vector3d a =
        switch (dice.below(4)) {
          case 0 -> new Vector3d(dice.sign(), 0.0, -0.0);
          case 1 -> new Vector3d(v.x(), v.y(), dice.sign() * 0.0);
          default -> v;
        };
    return switch (dice.below(3)) {
      case 0 -> new Vector3d(a.z(), a.x(), a.y());
      case 1 -> new Vector3d(a.y(), a.z(), a.x());
      default -> a;
    };
  }

  private static Cylinder cylinder(Dice dice, double topShare) {
    double height = dice.log(1e-6, 1e6);
    double radius = height * dice.log(1e-4, 1e4);
    Vector3d base = dice.cube(Math.max(height, radius) * dice.log(1e-3, 1e4));
    Vector3d top = base.plus(axis(dice).times(height));
    boolean upright = dice.below(2) == 0;
    double here = upright ? radius : radius * topShare;
    double there = upright ? radius * topShare : radius;
    return new Cylinder(base, top, here, there, dice.below(2) == 0);
  }

  /** A point of the side, a rim, the tip or a cap; a direction that grazes it. */
  private static Spot onCylinder(Dice dice, Cylinder c) {
    Vector3d along = c.top().minus(c.base());
    Vector3d a = along.normalized();
    double share = between(dice, 0, 1);
    double rho = c.radius() + share * (c.topRadius() - c.radius());
    Vector3d out = dice.across(a);
    double size = along.length() + c.radius() + c.topRadius();
    double part = dice.below(4) == 0 ? dice.in(0, 1) : 1;
    Vector3d p = c.base().plus(along.times(share)).plus(out.times(part * rho));
    double m = (c.topRadius() - c.radius()) / along.length();
    Vector3d n = out.minus(a.times(m)).normalized();
    return switch (dice.below(5)) {
      case 0 -> new Spot(p, a.times(dice.sign()), size);
      case 1 -> new Spot(p, a.plus(out.times(m)).normalized().times(dice.sign()), size);
      case 2 -> new Spot(p, dice.unit(), size);
      default -> new Spot(p, graze(dice, n, 1e-9), size);
    };
  }

  /** A direction at a small angle to a surface, from least to a right angle, on either side. */
  private static Vector3d graze(Dice dice, Vector3d n, double least) {
    double lift = dice.sign() * dice.log(least, 1);
    Vector3d d = dice.below(4) == 0 ? dice.unit() : dice.across(n).plus(n.times(lift));
    return d.normalized();
  }
}
