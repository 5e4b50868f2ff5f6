package glint.verify;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Sphere;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Placement;
import glint.scene.Scene;
import glint.trace.Tracer;
import java.util.List;

/** Transparent bodies that touch: what coincides is crossed as one. */
final class TouchingCases {

  private static final int DEEP = 12;

  private TouchingCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within(
            "R07", "two slabs that share a plane are one", 1e-12, "L", TouchingCases::touching),
        HardCase.within("R07-wet", "the same of two media", 1e-12, "L", TouchingCases::wet),
        HardCase.within(
            "R07-ball",
            "two balls in the same place are one",
            1e-12,
            "L",
            TouchingCases::twoBalls));
  }

  /** A slab from a height to another. */
  static Box slab(double low, double high) {
    return new Box(new Vector3d(-9, low, -9), new Vector3d(9, high, 9));
  }

  /** One slab, and two of the same that share a plane, in either order. */
  private static void touching(Tally tally) {
    touching(tally, 1.5);
  }

  /**
   * Water below glass: the two share a plane, or else the water reaches into the glass, which
   * displaces it.
   */
  private static void wet(Tally tally) {
    touching(tally, 1.33);
  }

  private static void touching(Tally tally, double n) {
    Dice dice = new Dice(2);
    for (int i = 0; i < tally.times(200, 5000); i++) {
      double low = dice.in(-2, 0);
      double joint = low + dice.log(1e-3, 1);
      double high = joint + dice.log(1e-3, 1);
      Transform place = place(dice, i);
      Transform shifted = Transform.translate(new Vector3d(0, joint, 0)).then(place);
      Material lower = Glass.of(n, Rgb.grey(0.25), 0);
      Material upper = Glass.of(1.5, Rgb.grey(0.25), 1 + dice.below(2));
      Scene.Builder one =
          Glass.sky()
              .place(new Placement(slab(low, (joint + high) / 2), place, lower))
              .place(new Placement(slab(joint, high), place, upper));
      if (n == 1.5) {
        one = Glass.sky().place(new Placement(slab(low, high), place, upper));
      }
      Placement below = new Placement(slab(low, joint), place, lower);
      Placement above =
          i % 3 == 0
              ? new Placement(slab(0, high - joint), shifted, upper)
              : new Placement(slab(joint + gap(dice, i), high), place, upper);
      Scene.Builder two = Glass.sky();
      two.place(i % 2 == 0 ? below : above).place(i % 2 == 0 ? above : below);
      compare(dice, one, two, tally);
    }
  }

  /**
   * A gap that is none, or one too narrow to be told from rounding: up to twice the distance by
   * which rays leave a box whose largest coordinate is 9.
   */
  private static double gap(Dice dice, int i) {
    return i % 4 == 0 ? dice.in(0, 1.9) * 2 * 0x1p-52 * 9 : 0;
  }

  /** Nowhere in particular, or turned and moved. */
  private static Transform place(Dice dice, int i) {
    if (i % 4 == 0) {
      return Transform.IDENTITY;
    }
    Quaternion turn = Quaternion.aboutAxis(dice.unit(), dice.in(0, 360));
    return Transform.rotate(turn).then(Transform.translate(dice.cube(i % 4 == 1 ? 3 : 1e-3)));
  }

  private static void compare(Dice dice, Scene.Builder a, Scene.Builder b, Tally tally) {
    Tracer first = Glass.tracer(a, DEEP);
    Tracer second = Glass.tracer(b, DEEP);
    for (int i = 0; i < 20; i++) {
      Vector3d from = dice.unit().times(40);
      Vector3d way = dice.cube(0.7).minus(from);
      tally.error(Math.abs(Glass.red(first, from, way) - Glass.red(second, from, way)));
      tally.check(true);
    }
  }

  private static void twoBalls(Tally tally) {
    Dice dice = new Dice(3);
    for (int i = 0; i < tally.times(100, 2000); i++) {
      Sphere ball = new Sphere(dice.cube(0.3), dice.in(0.5, 2));
      Placement one = Placement.of(ball, Glass.of(1.5, new Rgb(0.1, 0, 0), 1));
      Placement same = Placement.of(ball, Glass.of(1.5, new Rgb(0.1, 0, 0), i % 3));
      compare(dice, Glass.sky().place(one), Glass.sky().place(same).place(one), tally);
    }
  }
}
