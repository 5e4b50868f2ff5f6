package glint.verify;

import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.List;

/** Rays that leave a surface they have hit: none may hit it again, none may skip what is next. */
final class LeavingCases {

  private static final double[] RADII = {1e-3, 1, 1e6, 1e9};
  private static final double[] PLACES = {0, 1e6, 1e9};

  private LeavingCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact("S13", "leaving spheres outward, half grazing", LeavingCases::outOfSpheres),
        HardCase.within(
            "S14", "entering spheres", SphereOracle.PARAMETER, LeavingCases::intoSpheres),
        HardCase.exact("T14", "leaving triangles up to aspect 1e7", LeavingCases::triangles),
        leaving("plane", LeavingCases::plane),
        leaving("box", LeavingCases::box),
        leaving("cylinder", dice -> cylinder(dice, 1)),
        leaving("cone", dice -> cylinder(dice, dice.in(0, 0.9))),
        HardCase.exact("LEAVE-pipe", "leaving an open cylinder's inside", LeavingCases::pipes),
        leaving("ellipsoid", dice -> moved(dice, new Sphere(Vector3d.ZERO, 1))),
        leaving("turned-box", dice -> moved(dice, unitBox())),
        leaving("turned-cone", dice -> moved(dice, cone())));
  }

  /** A surface at its place, and how large it is there. */
  private record Placed(Surface surface, Transform toWorld, Vector3d middle, double size) {

    Vector3d someEye(Dice dice) {
      return middle.plus(dice.unit().times(size * dice.log(2, 100)));
    }
  }

  private interface Placer {
    Placed place(Dice dice);
  }

  private static HardCase leaving(String name, Placer placer) {
    return HardCase.exact(
        "LEAVE-" + name,
        "leaving outward, half grazing, near and far from the origin",
        tally -> leave(placer, tally));
  }

  private static void leave(Placer placer, Tally tally) {
    Dice dice = new Dice(99);
    for (int i = 0; i < tally.times(10_000, 100_000); i++) {
      Placed placed = placer.place(dice);
      Shoot shoot = Shoot.at(placed.surface, placed.toWorld);
      for (int k = 0; k < 20; k++) {
        Vector3d eye = placed.someEye(dice);
        if (shoot.through(eye, placed.middle.plus(dice.ball(placed.size)))) {
          shoot.resolve();
          Vector3d n = facing(shoot.normal(), placed.middle.minus(eye));
          tally.check(!shoot.leave(outward(dice, n, k % 2 == 0)));
        }
      }
    }
  }

  /** Turns a normal against a direction of view. */
  private static Vector3d facing(Vector3d n, Vector3d view) {
    return n.dot(view) > 0 ? n.negated() : n;
  }

  /** A direction away from a surface, by its rounded normal: any, or one that rises by 1e-6. */
  private static Vector3d outward(Dice dice, Vector3d n, boolean grazing) {
    double rise = grazing ? dice.log(1e-14, 1e-6) : dice.in(1e-6, 1);
    return dice.across(n).plus(n.times(rise)).times(dice.power(20));
  }

  private static void outOfSpheres(Tally tally) {
    Dice dice = new Dice(13);
    for (double r : RADII) {
      for (double place : PLACES) {
        for (int i = 0; i < tally.times(8, 40); i++) {
          Vector3d c = new Vector3d(dice.sign(), dice.in(-1, 1), dice.in(-1, 1)).times(place);
          Shoot shoot = Shoot.at(new Sphere(c, r));
          for (int k = 0; k < 1000; k++) {
            if (shoot.through(c.plus(dice.unit().times(3 * r)), c.plus(dice.ball(r)))) {
              shoot.resolve();
              tally.check(!shoot.leave(outward(dice, shoot.normal(), k % 2 == 0)));
            }
          }
        }
      }
    }
  }

  private static void intoSpheres(Tally tally) {
    Dice dice = new Dice(14);
    for (double r : RADII) {
      for (double place : PLACES) {
        for (int i = 0; i < tally.times(300, 20_000); i++) {
          Sphere s = new Sphere(dice.cube(place), r);
          Shoot shoot = Shoot.at(s);
          Vector3d eye = s.center().plus(dice.unit().times(3 * r));
          if (shoot.through(eye, s.center().plus(dice.ball(r)))) {
            shoot.resolve();
            enter(dice, s, shoot, tally);
          }
        }
      }
    }
  }

  /**
   * Crosses a sphere: exactly one hit, at the exact far root of the ray that left.
   *
   * <p>Leaving by an offset e below the surface shortens the chord 2r cos by e/cos, and storing the
   * origin rounds by as much: where that is less than a relative 1e-12, so is the error of t.
   */
  private static void enter(Dice dice, Sphere s, Shoot shoot, Tally tally) {
    Vector3d n = shoot.normal();
    double cos = dice.log(1e-3, 1);
    Vector3d d = dice.across(n).times(Math.sqrt(1 - cos * cos)).minus(n.times(cos)).normalized();
    boolean found = shoot.leave(d);
    List<Crossing> truth = new SphereOracle(s).crossings(shoot.origin(), d);
    Crossing far = truth.get(truth.size() - 1);
    tally.error(far.errorOf(shoot.hit.t));

    double chord = 2 * s.radius() * -d.dot(n);
    double offset = shoot.origin().minus(shoot.point()).length();
    boolean decided = 4 * offset <= 1e-12 * chord * -d.dot(n);
    boolean right = !decided || Math.abs(shoot.hit.t - chord) <= 1e-12 * chord;
    shoot.ray.tMin = shoot.hit.t;
    tally.check(found && right && !shoot.closest());
  }

  private static void triangles(Tally tally) {
    Dice dice = new Dice(141);
    for (double aspect : new double[] {1, 1e4, 1e7}) {
      for (double place : new double[] {0, 1e3, 1e6, 1e9}) {
        for (int i = 0; i < tally.times(600, 6000); i++) {
          Vector3d a = dice.cube(1).plus(dice.unit().times(place));
          Vector3d side = dice.unit();
          Vector3d width = dice.across(side).times(1 / aspect);
          Triangle t = new Triangle(a, a.plus(side), a.plus(side.times(0.5)).plus(width));
          leave(dice, t, Shoot.at(t), tally);
        }
      }
    }
  }

  private static void leave(Dice dice, Triangle t, Shoot shoot, Tally tally) {
    Vector3d p = t.b().minus(t.a());
    Vector3d q = t.c().minus(t.a());
    Exact3 a = Exact3.of(t.a());
    Exact3 normal = Exact3.of(t.b()).minus(a).cross(Exact3.of(t.c()).minus(a));
    for (int k = 0; k < 10; k++) {
      double u = dice.in(0, 1);
      double v = dice.in(0, 1 - u);
      Vector3d at = t.a().plus(p.times(u)).plus(q.times(v));
      if (shoot.through(at.plus(dice.unit().times(3)), at)) {
        Vector3d view = shoot.direction();
        shoot.resolve();
        Vector3d d = outward(dice, facing(shoot.normal(), view), k % 2 == 0);
        // A sliver's normal errs by u times its aspect: what rises less may in truth go through.
        int side = Exact3.of(view).dot(normal).signum();
        if (Exact3.of(d).dot(normal).signum() == -side) {
          tally.check(!shoot.leave(d));
        }
      }
    }
  }

  private static void pipes(Tally tally) {
    Dice dice = new Dice(98);
    for (int i = 0; i < tally.times(10_000, 100_000); i++) {
      double size = dice.log(1e-3, 1e3);
      Vector3d base = somewhere(dice, size);
      Vector3d axis = dice.unit().times(size);
      double r = size * dice.log(0.01, 1);
      Cylinder pipe = new Cylinder(base, base.plus(axis), r, r * dice.in(0.5, 1), false);
      Shoot shoot = Shoot.at(pipe);
      for (int k = 0; k < 10; k++) {
        if (shoot.from(base.plus(axis.times(dice.in(0.2, 0.8))), dice.across(axis))) {
          shoot.resolve();
          Vector3d n = facing(shoot.normal(), shoot.direction());
          Vector3d d = outward(dice, n, false);
          // The chord of a circle of the least radius, less what a steep ray may save.
          boolean again = shoot.leave(d);
          double way = shoot.hit.t * d.length();
          tally.check(!again || way > 0.1 * r * d.dot(n) / d.length());
        }
      }
    }
  }

  private static Vector3d somewhere(Dice dice, double size) {
    return dice.unit().times(dice.below(4) == 0 ? 0 : size * dice.log(1, 1e9));
  }

  private static Placed plane(Dice dice) {
    Vector3d p = somewhere(dice, 1);
    return new Placed(new Plane(p, dice.unit()), Transform.IDENTITY, p, 1);
  }

  private static Placed box(Dice dice) {
    double size = dice.log(1e-3, 1e3);
    Vector3d min = somewhere(dice, size);
    Vector3d max = min.plus(new Vector3d(1, dice.in(0.1, 1), dice.in(0.1, 1)).times(size));
    return new Placed(new Box(min, max), Transform.IDENTITY, min.plus(max).times(0.5), size);
  }

  private static Placed cylinder(Dice dice, double topShare) {
    double size = dice.log(1e-3, 1e3);
    Vector3d base = somewhere(dice, size);
    Vector3d along = dice.unit().times(size);
    double r = size * dice.log(0.01, 1);
    Cylinder c = new Cylinder(base, base.plus(along), r, r * topShare, true);
    return new Placed(c, Transform.IDENTITY, base.plus(along.times(0.5)), size);
  }

  private static Box unitBox() {
    return new Box(new Vector3d(-1, -1, -1), new Vector3d(1, 1, 1));
  }

  private static Cylinder cone() {
    return new Cylinder(new Vector3d(0, 0, -1), new Vector3d(0, 0, 1), 1, 0.5, true);
  }

  /** Scales, turns and moves a surface of size 1. */
  private static Placed moved(Dice dice, Surface surface) {
    double size = dice.log(1e-3, 1e3);
    Vector3d factors = new Vector3d(1, dice.log(1e-4, 1), dice.log(1e-4, 1)).times(size);
    Vector3d to = somewhere(dice, size);
    double angle = dice.below(2) == 0 ? dice.in(0, 360) : dice.log(1e-9, 360);
    Transform place =
        Transform.scale(factors)
            .then(Transform.rotate(Quaternion.aboutAxis(dice.unit(), angle)))
            .then(Transform.translate(to));
    return new Placed(surface, place, to, size);
  }
}
