package glint.verify;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.light.Light;
import glint.math.Rounding;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Placement;
import glint.scene.Scene;
import glint.trace.Tracer;
import java.math.BigDecimal;
import java.util.List;

/** Transparent bodies: invisible ones, and ones that absorb. */
final class BodyCases {

  private static final int DEEP = 12;

  private BodyCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within("R01", "a body of n = 1 is invisible", 1e-12, "L", BodyCases::invisible),
        HardCase.exact("R09", "two absorbing halves are one body", BodyCases::oneBody),
        HardCase.within(
            "R09-media", "halves of different media", 4, "u(1+σt)", BodyCases::twoBodies),
        HardCase.within(
            "R10", "the shadow of an absorbing ball", 1e-12, "L", BodyCases::colouredShadow),
        HardCase.within(
            "R10-lamp", "a lamp inside an absorbing ball", 1e-12, "L", BodyCases::lampInside));
  }

  /** Placed among, around and through everything, as a filter and as a medium. */
  private static void invisible(Tally tally) {
    Dice dice = new Dice(1);
    double[] without = Pictures.pixels(SampleWorld.PLAIN.scene());
    for (int i = 0; i < tally.times(12, 200); i++) {
      Vector3d place = dice.cube(3);
      double size = i % 4 == 0 ? 20 : dice.in(0.2, 2);
      Surface body =
          i % 3 == 0
              ? new Box(place, place.plus(new Vector3d(size, size, size)))
              : new Sphere(place, size);
      Scene.Builder scene = SampleWorld.PLAIN.scene();
      scene.place(Placement.of(body, Glass.of(1, Rgb.BLACK, i % 2)));
      scene.place(Placement.of(new Sphere(place, size / 2), Glass.of(1)));
      differ(without, Pictures.pixels(scene), tally);
    }
  }

  private static void differ(double[] a, double[] b, Tally tally) {
    for (int i = 0; i < a.length; i++) {
      tally.error(Math.abs(a[i] - b[i]));
      tally.check(true);
    }
  }

  /** Halves of one medium are one body, bit for bit. */
  private static void oneBody(Tally tally) {
    halves(tally, 0, (whole, parts, depth) -> tally.check(whole == parts));
  }

  /**
   * Between different media light fades twice. Each exponent errs by 2u of itself, the differences
   * of t and the products; three exponentials and a product err by u each.
   */
  private static void twoBodies(Tally tally) {
    halves(
        tally,
        1,
        (whole, parts, depth) -> {
          tally.error(Math.abs(parts / whole - 1) / (Rounding.U * (1 + depth)));
          tally.check(true);
        });
  }

  private interface Judge {
    /** Compares what comes through a slab and its two halves, given their optical depth. */
    void compare(double whole, double parts, double depth);
  }

  private static void halves(Tally tally, int priority, Judge judge) {
    Dice dice = new Dice(4);
    for (int i = 0; i < tally.times(2000, 50_000); i++) {
      double thickness = dice.log(1e-3, 4);
      double sigma = dice.log(1e-2, 4);
      Material a = Glass.of(1, Rgb.grey(sigma), 0);
      Material b = Glass.of(1, Rgb.grey(sigma), priority);
      Scene.Builder one = Glass.field().place(Placement.of(TouchingCases.slab(0, thickness), a));
      Scene.Builder two =
          Glass.field()
              .place(Placement.of(TouchingCases.slab(0, thickness / 2), a))
              .place(Placement.of(TouchingCases.slab(thickness / 2, thickness), b));
      Vector3d from = new Vector3d(0, 4, 0);
      Vector3d way = new Vector3d(dice.in(-1, 1), -1, dice.in(-1, 1));
      double whole = Glass.red(Glass.tracer(one, DEEP), from, way);
      double parts = Glass.red(Glass.tracer(two, DEEP), from, way);
      judge.compare(whole, parts, sigma * thickness * way.length());
    }
  }

  /** The light of lamps, near or endlessly far, on a floor, E·cosθ·exp(-σ·2√(r² - b²)). */
  private static void colouredShadow(Tally tally) {
    Dice dice = new Dice(5);
    for (int i = 0; i < tally.times(500, 20_000); i++) {
      Vector3d up = dice.unit();
      Vector3d light = dice.across(up).times(dice.in(0, 2)).plus(up).normalized();
      Sphere ball = new Sphere(light.times(dice.in(3, 6)), dice.in(0.1, 1));
      Vector3d lamp = light.times(dice.in(8, 20));
      Rgb sigma = new Rgb(dice.in(0, 3), dice.in(0, 3), 0);
      Scene.Builder scene =
          Glass.field()
              .background(Background.BLACK)
              .light(
                  i % 2 == 0
                      ? new Light.Directional(light.negated(), Rgb.grey(0.8))
                      : new Light.Point(lamp, Rgb.grey(0.8), false))
              .place(Placement.of(new Plane(Vector3d.ZERO, up), Pictures.CHALK))
              .place(Placement.of(ball, Glass.of(1, sigma, 0)));
      Tracer tracer = Glass.tracer(scene, DEEP);
      for (int k = 0; k < 10; k++) {
        Vector3d aside = dice.across(light).times(ball.radius() * dice.in(0, 1.2));
        Vector3d on = aside.minus(light.times(aside.dot(up) / light.dot(up)));
        Vector3d to = i % 2 == 0 ? light : lamp.minus(on);
        double across = chord(ball, on, to);
        if (across >= 0) {
          double lit = 0.8 * to.normalized().dot(up);
          double seen = Glass.red(tracer, on.plus(up.times(0.1)), up.negated());
          tally.error(Math.abs(seen - lit * StrictMath.exp(-sigma.r() * across)));
          tally.error(Math.abs(tracer.g - lit * StrictMath.exp(-sigma.g() * across)));
          tally.error(Math.abs(tracer.b - lit));
          tally.check(true);
        }
      }
    }
  }

  /** All light goes through one radius of the ball: E·cosθ·exp(-σ·r). */
  private static void lampInside(Tally tally) {
    Dice dice = new Dice(6);
    for (int i = 0; i < tally.times(200, 10_000); i++) {
      double height = dice.in(1, 8);
      double radius = dice.in(0.1, 0.8) * height;
      double sigma = dice.in(0, 3);
      Vector3d lamp = Pictures.UP.times(height);
      Scene.Builder scene =
          Glass.field()
              .background(Background.BLACK)
              .light(new Light.Point(lamp, Rgb.grey(0.8), false))
              .place(Placement.of(new Plane(Vector3d.ZERO, Pictures.UP), Pictures.CHALK))
              .place(Placement.of(new Sphere(lamp, radius), Glass.of(1, Rgb.grey(sigma), 0)));
      Tracer tracer = Glass.tracer(scene, DEEP);
      Vector3d on = dice.across(Pictures.UP).times(dice.in(0, 9));
      double seen = Glass.red(tracer, on.plus(new Vector3d(0, 1e-3, 0)), Pictures.UP.negated());
      double cos = height / Math.sqrt(height * height + on.dot(on));
      tally.error(Math.abs(seen - 0.8 * cos * StrictMath.exp(-sigma * radius)));
      tally.check(true);
    }
  }

  /** How far light goes through a ball; -1 next to its rim, where rounding decides. */
  private static double chord(Sphere ball, Vector3d on, Vector3d light) {
    Exact3 way = Exact3.of(ball.center()).minus(Exact3.of(on));
    Exact3 l = Exact3.of(light);
    BigDecimal b2 = Exact.ratio(way.cross(l).squared(), l.squared());
    double half2 = Exact.toDouble(Exact.square(Exact.of(ball.radius())).subtract(b2));
    if (Math.abs(half2) < 1e-3 * ball.radius() * ball.radius()) {
      return -1;
    }
    return half2 < 0 ? 0 : 2 * Math.sqrt(half2);
  }
}
