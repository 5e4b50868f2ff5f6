package glint.verify;

import glint.geometry.Hit;
import glint.geometry.Primitives;
import glint.geometry.Triangle;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Triangles: shared edges, corners, slivers, planes seen edge-on and things that have no area. */
final class TriangleCases {

  private static final Vector3d Z = new Vector3d(0, 0, 1);

  private TriangleCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact("T01", "the diagonal of a quad of two triangles", TriangleCases::diagonal),
        HardCase.exact("T05", "a dyadic T-junction", TriangleCases::junction),
        HardCase.exact("T06", "corners and edges belong: t = 1 exactly", TriangleCases::corners),
        HardCase.exact("T07", "2^-60 outside an edge", TriangleCases::justOutside),
        HardCase.within("T08", "slivers, aspect 1e4 and 1e8", 1e-8, "t", TriangleCases::slivers),
        HardCase.exact("T09", "t of a grazed sliver lies on it", TriangleCases::grazedSliver),
        HardCase.exact("T10", "no area: never hit", TriangleCases::degenerate),
        HardCase.exact("T11", "a ray in the plane misses", TriangleCases::inPlane),
        HardCase.exact("T13", "of two the lower number wins", TriangleCases::duplicate),
        HardCase.exact("T15", "seen at gap 1e-13 and more", TriangleCases::nearOccluder));
  }

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static void diagonal(Tally tally) {
    Dice dice = new Dice(1);
    Triangle below = new Triangle(v(0, 0, 0), v(1, 0, 0), v(1, 1, 0));
    Triangle above = new Triangle(v(0, 0, 0), v(1, 1, 0), v(0, 1, 0));
    Shoot shoot = Shoot.at(below, above);
    for (int i = 0; i < 1000; i++) {
      Vector3d p = v(i / 1024.0, i / 1024.0, 0);
      tally.check(shoot.through(p.plus(v(0, 0, -1)), p) && shoot.hit.t == 1);
      tally.check(shoot.through(p.plus(dice.unit().times(dice.log(0.01, 1e6))), p));
    }
  }

  private static void junction(Tally tally) {
    Vector3d middle = v(1, 0, 0);
    Shoot shoot =
        Shoot.at(
            new Triangle(v(0, 0, 0), v(2, 0, 0), v(1, -1, 0)),
            new Triangle(v(0, 0, 0), middle, v(0.5, 1, 0)),
            new Triangle(middle, v(2, 0, 0), v(1.5, 1, 0)));
    Vector3d[] directions = {Z, v(0.125, 0.0625, 1), v(-0.25, 0.5, -1), v(1, 0.5, 0.125)};
    for (int i = 0; i <= 1024; i++) {
      for (Vector3d d : directions) {
        Vector3d o = v(i / 512.0, 0, 0).minus(d);
        tally.check(shoot.from(o, d) && shoot.hit.t == 1);
      }
    }
  }

  private static Triangle corner() {
    return new Triangle(v(0, 0, 0), v(1, 0, 0), v(0, 1, 0));
  }

  private static void corners(Tally tally) {
    Shoot shoot = Shoot.at(corner());
    for (Vector3d p : List.of(v(0, 0, -1), v(1, 0, -1), v(0.5, 0.5, -1), v(0, 0.25, -1))) {
      tally.check(shoot.from(p, Z) && shoot.hit.t == 1);
    }
  }

  private static void justOutside(Tally tally) {
    Shoot shoot = Shoot.at(corner());
    tally.check(!shoot.from(v(0.25, -0x1p-60, -1), Z));
    tally.check(!shoot.from(v(-0x1p-60, 0.25, -1), Z));
    tally.check(!shoot.from(v(0.5, Math.nextUp(0.5), -1), Z));
  }

  private static void slivers(Tally tally) {
    Dice dice = new Dice(8);
    for (double aspect : new double[] {1e4, 1e8}) {
      for (int i = 0; i < tally.times(200, 3000); i++) {
        Triangle t = sliver(dice, aspect);
        Shoot shoot = Shoot.at(t);
        TriangleOracle oracle = new TriangleOracle(t);
        Vector3d n = t.b().minus(t.a()).cross(t.c().minus(t.a())).normalized();
        for (int k = 0; k < 10; k++) {
          Vector3d d = n.times(dice.sign());
          Vector3d o = inside(dice, t, -0.5, 1.5).minus(d.times(dice.in(1, 3)));
          Crossing truth = oracle.crossings(o, d).get(0);
          boolean hit = shoot.from(o, d);
          tally.check(hit == (truth.inside() >= 0));
          if (hit) {
            tally.error(Math.abs(shoot.hit.t / Exact.toDouble(truth.t()) - 1));
          }
        }
      }
    }
  }

  private static Triangle sliver(Dice dice, double aspect) {
    Vector3d a = dice.cube(1);
    Vector3d side = dice.unit();
    Vector3d width = dice.across(side).times(1 / aspect);
    return new Triangle(a, a.plus(side), a.plus(side.times(dice.in(0, 1))).plus(width));
  }

  private static Vector3d inside(Dice dice, Triangle t, double least, double greatest) {
    Vector3d along = t.b().minus(t.a()).times(dice.in(least, greatest));
    return t.a().plus(along).plus(t.c().minus(t.a()).times(dice.in(least, greatest)));
  }

  /** A ray at an angle of 1e-8 to a sliver's plane (Embree's issue 387). */
  private static void grazedSliver(Tally tally) {
    Dice dice = new Dice(9);
    for (int i = 0; i < 60_000; i++) {
      Triangle t = sliver(dice, 1e4);
      Vector3d side = t.b().minus(t.a());
      Vector3d n = side.cross(t.c().minus(t.a())).normalized();
      Vector3d flat = side.normalized().plus(n.cross(side).times(dice.in(-1, 1))).normalized();
      Vector3d d = flat.plus(n.times(1e-8));
      Vector3d o = inside(dice, t, 0, 1).minus(d.times(dice.in(1, 3)));
      Shoot shoot = Shoot.at(t);
      boolean right = true;
      if (shoot.from(o, d)) {
        double a = t.a().minus(o).dot(d) / d.dot(d);
        double b = t.b().minus(o).dot(d) / d.dot(d);
        double c = t.c().minus(o).dot(d) / d.dot(d);
        double least = Math.min(a, Math.min(b, c)) - 1e-6;
        right = shoot.hit.t >= least && shoot.hit.t <= Math.max(a, Math.max(b, c)) + 1e-6;
      }
      tally.check(right);
    }
  }

  /** Corners that coincide, and corners on a line: whole numbers, so that they do exactly. */
  private static void degenerate(Tally tally) {
    Dice dice = new Dice(10);
    for (int i = 0; i < 20_000; i++) {
      Vector3d a = whole(dice);
      Vector3d e = whole(dice);
      Vector3d b = a.plus(e.times(dice.below(3)));
      Vector3d c = a.plus(e.times(dice.below(9) - 4));
      Primitives counted = Shoot.primitives(List.of(new Triangle(a, b, c)));
      Shoot shoot = Shoot.scanning(counted);
      tally.check(counted.degenerate() == 1);
      Vector3d o = dice.cube(4000);
      tally.check(!shoot.through(o, a.plus(e.times(dice.in(-4, 4)))));
      tally.check(!shoot.through(o, a) && !Double.isNaN(shoot.hit.t));
    }
  }

  private static Vector3d whole(Dice dice) {
    return v(dice.below(2001) - 1000, dice.below(2001) - 1000, dice.below(2001) - 1000);
  }

  /** Eye and direction are whole multiples of two edges: in the triangle's plane exactly. */
  private static void inPlane(Tally tally) {
    Dice dice = new Dice(11);
    for (int i = 0; i < 20_000; i++) {
      Vector3d a = whole(dice);
      Vector3d p = whole(dice);
      Vector3d q = whole(dice);
      Shoot shoot = Shoot.at(new Triangle(a, a.plus(p), a.plus(q)));
      Vector3d o = a.plus(p.times(-1 - dice.below(9))).plus(q.times(dice.below(9)));
      Vector3d d = p.times(1 + dice.below(9)).plus(q.times(dice.below(9) - 4));
      tally.check(!shoot.from(o, d));
    }
    // From inside a cube along its middle planes the neighbours are hit.
    ClosedMesh cube = ClosedMesh.cube(1);
    Shoot shoot = Shoot.scanning(cube.primitives());
    for (int i = 0; i < 1000; i++) {
      double angle = dice.in(0, 7);
      Vector3d d = v(StrictMath.cos(angle), 0, StrictMath.sin(angle));
      tally.check(shoot.from(Vector3d.ZERO, d));
    }
  }

  private static void duplicate(Tally tally) {
    Dice dice = new Dice(13);
    for (int i = 0; i < 200; i++) {
      List<Triangle> soup = new ArrayList<>();
      for (int k = 0; k < 20; k++) {
        soup.add(new Triangle(dice.cube(9), dice.cube(9), dice.cube(9)));
      }
      soup.addAll(List.copyOf(soup));
      Collections.rotate(soup, dice.below(20));
      Shoot scan = Shoot.scanning(Shoot.primitives(soup));
      Shoot tree = Shoot.throughTree(Shoot.primitives(soup));
      for (int k = 0; k < 20; k++) {
        Vector3d o = dice.cube(20);
        Vector3d to = inside(dice, soup.get(k), 0, 0.5);
        boolean hit = scan.through(o, to) && tree.through(o, to);
        tally.check(hit && scan.hit.primitive < 20 && isSame(scan.hit, tree.hit));
      }
    }
  }

  private static boolean isSame(Hit a, Hit b) {
    return a.primitive == b.primitive && a.t == b.t;
  }

  private static void nearOccluder(Tally tally) {
    Dice dice = new Dice(15);
    for (int i = 0; i < 10_000; i++) {
      double gap = i % 2 == 0 ? 1e-13 : dice.log(1e-13, 1e-3);
      double x = -dice.in(0.01, 0.9);
      double y = -dice.in(0.01, 0.98 + x);
      Triangle t = new Triangle(v(x, y, gap), v(x + 1, y, gap), v(x, y + 1, gap));
      tally.check(Shoot.at(t).from(Vector3d.ZERO, Z));
      tally.check(Shoot.at(t).from(Vector3d.ZERO, v(dice.in(-1, 1), dice.in(-1, 1), 1)));
    }
  }
}
