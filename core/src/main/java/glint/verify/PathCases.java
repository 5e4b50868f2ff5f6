package glint.verify;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Plane;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.math.Rounding;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.trace.RayTree;
import glint.trace.Recorder;
import glint.trace.Tracer;
import java.math.BigDecimal;
import java.util.List;

/** Rays that go in and come out again, followed one by one. */
final class PathCases {

  private static final Rgb FAINT = Rgb.grey(0.125);

  private PathCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within("R05", "a slab's exit is as its entry", 4, "u/cos", PathCases::direction),
        HardCase.within("R05-shift", "a slab's shift", 1e-12, "t", PathCases::shift),
        HardCase.within("R06", "water that reaches into its glass", 1e-10, "L", PathCases::nested),
        HardCase.within("R12", "into glass at 90° - 1e-9", 4, "u", PathCases::grazing));
  }

  /** Traces a ray and tells what became of it. */
  private static RayTree follow(Prepared scene, Vector3d from, Vector3d unit, int depth) {
    Recorder recorder = new Recorder();
    Tracer tracer = new Tracer(scene, depth, Glass.NEGLIGIBLE, recorder);
    Ray ray = new Ray();
    ray.set(from.x(), from.y(), from.z(), unit.x(), unit.y(), unit.z());
    tracer.trace(ray, Double.POSITIVE_INFINITY);
    return recorder.tree();
  }

  /** Follows a ray down the branches that go through, so many times. */
  private static RayTree through(Scene.Builder scene, Vector3d from, Vector3d unit, int times) {
    RayTree tree = follow(Prepared.of(scene.build()), from, unit, times);
    for (int i = 0; i < times; i++) {
      tree =
          tree.children().stream()
              .filter(child -> child.kind() == RayTree.Kind.REFRACTION)
              .findAny()
              .get();
    }
    return tree;
  }

  /** Returns a direction down at some angle to the normal, grazing ones included. */
  private static Vector3d down(Dice dice) {
    double steep = dice.log(1e-3, 1e3);
    return dice.across(Pictures.UP).minus(Pictures.UP.times(steep)).normalized();
  }

  private static Scene.Builder slab(double thickness, double n) {
    Box box = new Box(new Vector3d(-20, -thickness, -20), new Vector3d(20, 0, 20));
    return Glass.field().place(Placement.of(box, Glass.of(n)));
  }

  /**
   * cos t = √(1 - sin² t) errs by u/cos t for every u of sin² t; else the direction that comes out
   * is that of the line that goes in, whose numbers are a unit vector only to within u.
   */
  private static void direction(Tally tally) {
    Dice dice = new Dice(1);
    for (int i = 0; i < tally.times(5000, 200_000); i++) {
      Vector3d in = down(dice);
      double n = i % 2 == 0 ? 1.5 : dice.in(1.01, 3);
      Vector3d from = in.times(-0.5 / -in.y());
      Vector3d out = through(slab(dice.in(0.1, 2), n), from, in, 2).direction();
      Exact3 line = Exact3.of(in);
      BigDecimal length = Exact.sqrt(line.squared());
      Exact3 off = Exact3.of(out).times(length).minus(line);
      tally.error(off.toDoubles().maxAbs() * -in.y() / Rounding.U);
      tally.check(true);
    }
  }

  /** t·sinθ(1 - cosθ/√(n² - sin²θ)), for a slab of thickness t. */
  private static void shift(Tally tally) {
    Dice dice = new Dice(2);
    for (int i = 0; i < tally.times(5000, 200_000); i++) {
      Vector3d in = down(dice);
      double n = i % 2 == 0 ? 1.5 : dice.in(1.01, 3);
      double thickness = dice.log(0.01, 2);
      Vector3d from = in.times(-0.5 / -in.y());
      Vector3d out = through(slab(thickness, n), from, in, 2).origin();
      double aside = Exact3.of(out).minus(Exact3.of(from)).cross(Exact3.of(in)).length();
      double sin2 = (1 + in.y()) * (1 - in.y());
      double expected = Math.sqrt(sin2) * (1 + in.y() / Math.sqrt(n * n - sin2));
      tally.error(Math.abs(aside - thickness * expected));
      tally.check(true);
    }
  }

  private static void grazing(Tally tally) {
    Dice dice = new Dice(3);
    Plane glass = new Plane(Vector3d.ZERO, Pictures.UP);
    for (int i = 0; i < tally.times(2000, 50_000); i++) {
      double rise = StrictMath.sin(i % 2 == 0 ? 1e-9 : dice.log(1e-15, 1e-6));
      Vector3d in = dice.across(Pictures.UP).minus(Pictures.UP.times(rise)).normalized();
      double n = i % 2 == 0 ? 1.5 : dice.in(1.01, 4);
      Scene.Builder scene = Glass.field().place(Placement.of(glass, Glass.of(n)));
      RayTree below = through(scene, new Vector3d(0, 1e-3, 0), in, 1);
      Exact3 out = Exact3.of(below.direction());
      double square = Exact.toDouble(out.squared().subtract(Exact.of(1)));
      tally.error(Math.abs(square) / 2 / Rounding.U);
      Rgb weight = below.weight();
      tally.check(below.direction().y() < 0 && weight.r() > 0 && weight.r() < 100 * rise);
    }
  }

  /**
   * Three ways to fill a hollow glass with water: to the brim of the hollow and no farther, as a
   * ball that reaches into the glass, and as a drop in solid glass that displaces it.
   */
  private static void nested(Tally tally) {
    Dice dice = new Dice(4);
    for (int i = 0; i < tally.times(10, 1000); i++) {
      double inner = dice.in(0.3, 0.7);
      ClosedMesh hollow = ClosedMesh.globe(inner, 6 + i % 9, 12);
      ClosedMesh outer = ClosedMesh.globe(1, 12, 24);
      Placement glass = Placement.of(outer.around(hollow).surface(), Glass.of(1.5, FAINT, 2));
      Material water = Glass.of(1.33, Rgb.BLACK, 1);
      Sphere ball = new Sphere(dice.ball(0.1), dice.in(inner + 0.11, 0.85));
      Prepared exact = prepared(glass, Placement.of(hollow.surface(), water));
      Prepared reaching = prepared(glass, Placement.of(ball, water));
      Prepared drop =
          prepared(
              Placement.of(outer.surface(), Glass.of(1.5, FAINT, 2)),
              Placement.of(hollow.surface(), Glass.of(1.33, Rgb.BLACK, 3)));
      for (int k = 0; k < 10; k++) {
        Vector3d from = dice.unit().times(3);
        Vector3d way = dice.ball(0.9).minus(from).normalized();
        RayTree truth = follow(exact, from, way, 6);
        compare(truth, follow(reaching, from, way, 6), tally);
        compare(truth, follow(drop, from, way, 6), tally);
      }
    }
  }

  private static Prepared prepared(Placement a, Placement b) {
    return Prepared.of(Glass.field().place(a).place(b).build());
  }

  /** Compares two trees of rays: their directions, and their lengths in each medium. */
  private static void compare(RayTree a, RayTree b, Tally tally) {
    List<RayTree> first = a.rays();
    List<RayTree> second = b.rays();
    tally.check(first.size() == second.size());
    for (int i = 0; i < Math.min(first.size(), second.size()); i++) {
      RayTree.Meeting there = first.get(i).met().orElse(null);
      RayTree.Meeting here = second.get(i).met().orElse(null);
      tally.error(first.get(i).direction().minus(second.get(i).direction()).maxAbs());
      if (there != null && here != null) {
        tally.error(Math.abs(there.t() * there.before().ior() - here.t() * here.before().ior()));
      }
      tally.check((there == null) == (here == null));
    }
  }
}
