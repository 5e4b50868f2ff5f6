package glint.verify;

import glint.math.Quaternion;
import glint.math.Rounding;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.scene.Camera;
import glint.scene.Projection;
import glint.scene.View;
import java.math.BigDecimal;
import java.util.List;

/** Rotations as quaternions: their length, products, ways between them, and matrices. */
final class QuaternionCases {

  private static final double[] NO_NUMBERS = {0, Double.NaN, Double.POSITIVE_INFINITY};

  private QuaternionCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within("Q02", "360 turns by 1°: |w| - 1", 1e-14, "-", QuaternionCases::round),
        HardCase.within(
            "Q03", "matrix to quaternion, up to 180°", 1e-14, "rad", QuaternionCases::matrices),
        HardCase.within("Q04", "slerp by angles from 1e-9", 4, "u", QuaternionCases::slerps),
        HardCase.within("Q05", "slerp takes the shorter way", 4, "u", QuaternionCases::shorter),
        HardCase.within(
            "Q06", "any length becomes 1, none is refused", 2, "u", QuaternionCases::units),
        HardCase.within(
            "C07", "a camera after 10^6 turns: length, frame", 4, "u", QuaternionCases::drift));
  }

  private static Quaternion any(Dice dice) {
    return Quaternion.aboutAxis(dice.unit(), dice.in(-360, 360));
  }

  private static Quaternion negative(Quaternion q) {
    return new Quaternion(-q.w(), -q.x(), -q.y(), -q.z());
  }

  private static void round(Tally tally) {
    Dice dice = new Dice(2);
    for (int i = 0; i < 100; i++) {
      Quaternion step = Quaternion.aboutAxis(dice.unit(), 1);
      Quaternion q = new Quaternion(1, 0, 0, 0);
      for (int k = 0; k < 360; k++) {
        q = q.then(step);
      }
      tally.error(Math.abs(Math.abs(q.w()) - 1));
      tally.check(q.w() < 0); // a full turn is half of the way to itself
    }
  }

  /** Returns the angle by which two rotations differ. */
  private static double between(Quaternion a, Quaternion b) {
    double least = Double.POSITIVE_INFINITY;
    for (double s : new double[] {1, -1}) {
      double w = a.w() - s * b.w();
      double x = a.x() - s * b.x();
      double y = a.y() - s * b.y();
      double z = a.z() - s * b.z();
      least = Math.min(least, 2 * Math.sqrt(w * w + x * x + y * y + z * z));
    }
    return least;
  }

  private static void matrices(Tally tally) {
    Dice dice = new Dice(3);
    for (int i = 0; i < tally.times(10_000, 1_000_000); i++) {
      double less = i % 3 == 0 ? dice.in(0, StrictMath.PI) : StrictMath.pow(10, -dice.below(10));
      double degrees = StrictMath.toDegrees(StrictMath.PI - less);
      Vector3d axis = i % 7 == 0 ? new Vector3d(i % 2, i / 2 % 2, 1) : dice.unit();
      Quaternion q = Quaternion.aboutAxis(axis, degrees);
      Transform m = Transform.rotate(q);
      Quaternion back =
          Quaternion.ofAxes(
              m.direction(new Vector3d(1, 0, 0)),
              m.direction(new Vector3d(0, 1, 0)),
              m.direction(new Vector3d(0, 0, 1)));
      tally.error(between(q, back));
      tally.check(true);
    }
  }

  /** The four numbers of a quaternion without rounding, or rounded to sixty digits. */
  private record Four(BigDecimal[] v) {

    static Four of(Quaternion q) {
      return new Four(
          new BigDecimal[] {Exact.of(q.w()), Exact.of(q.x()), Exact.of(q.y()), Exact.of(q.z())});
    }

    BigDecimal dot(Four b) {
      BigDecimal sum = BigDecimal.ZERO;
      for (int i = 0; i < 4; i++) {
        sum = sum.add(v[i].multiply(b.v[i]));
      }
      return sum;
    }

    Four plus(Four b, BigDecimal times) {
      BigDecimal[] sum = new BigDecimal[4];
      for (int i = 0; i < 4; i++) {
        sum[i] = v[i].add(b.v[i].multiply(times));
      }
      return new Four(sum);
    }

    BigDecimal length() {
      return Exact.sqrt(dot(this));
    }

    Four unit() {
      BigDecimal length = length();
      BigDecimal[] unit = new BigDecimal[4];
      for (int i = 0; i < 4; i++) {
        unit[i] = Exact.ratio(v[i], length);
      }
      return new Four(unit);
    }
  }

  /** Halves the angle six times: what lies halfway between unit vectors is their sum, shortened. */
  private static Four halfway(Four from, Four to, int sixtyFourths) {
    Four low = from;
    Four high = to;
    int at = 0;
    for (int step = 32; step > 0; step /= 2) {
      Four middle = low.plus(high, BigDecimal.ONE).unit();
      boolean above = sixtyFourths >= at + step;
      at += above ? step : 0;
      low = above ? middle : low;
      high = above ? high : middle;
    }
    return low;
  }

  /** Notes by how much a step is off the way, and its length off 1, both in u. */
  private static void compare(Quaternion a, Quaternion b, int sixtyFourths, Tally tally) {
    Four from = Four.of(a).unit();
    Four to = Four.of(b).unit();
    boolean behind = from.dot(to).signum() < 0;
    Four truth = halfway(from, behind ? Four.of(negative(b)).unit() : to, sixtyFourths);
    Four found = Four.of(a.slerp(b, sixtyFourths / 64.0));
    BigDecimal off = found.plus(truth, BigDecimal.ONE.negate()).length();
    BigDecimal longer = found.length().subtract(BigDecimal.ONE);
    tally.error(Exact.toDouble(off) / Rounding.U);
    tally.error(Math.abs(Exact.toDouble(longer)) / Rounding.U);
    tally.check(true);
  }

  private static void slerps(Tally tally) {
    Dice dice = new Dice(4);
    for (int i = 0; i < tally.times(1000, 50_000); i++) {
      Quaternion a = any(dice);
      double angle = StrictMath.toDegrees(dice.log(1e-9, 1.5));
      Quaternion b = a.then(Quaternion.aboutAxis(dice.unit(), angle));
      compare(a, b, dice.below(64), tally);
    }
  }

  private static void shorter(Tally tally) {
    Dice dice = new Dice(5);
    for (int i = 0; i < tally.times(300, 20_000); i++) {
      Quaternion a = any(dice);
      double angle = StrictMath.toDegrees(dice.log(1e-9, 3));
      Quaternion b = negative(a.then(Quaternion.aboutAxis(dice.unit(), angle)));
      compare(a, b, dice.below(64), tally);
      Quaternion opposite = negative(a);
      compare(a, opposite, dice.below(64), tally);
      boolean exactly = opposite.w() == -a.w() && opposite.x() == -a.x();
      exactly &= opposite.y() == -a.y() && opposite.z() == -a.z();
      tally.check(!exactly || a.slerp(opposite, dice.in(0, 1)).equals(a));
    }
  }

  private static void units(Tally tally) {
    Dice dice = new Dice(6);
    for (int i = 0; i < tally.times(20_000, 1_000_000); i++) {
      double size = i % 2 == 0 ? StrictMath.pow(10, dice.in(-200, 200)) : 1;
      Vector3d v = dice.unit().times(size);
      Quaternion q = new Quaternion(dice.in(-1, 1) * size, v.x(), v.y(), v.z());
      BigDecimal more = Four.of(q).dot(Four.of(q)).subtract(BigDecimal.ONE);
      tally.error(Math.abs(Exact.toDouble(more)) / 2 / Rounding.U);
      tally.check(true);
    }
    for (double bad : NO_NUMBERS) {
      tally.check(isRefused(bad));
    }
  }

  private static boolean isRefused(double bad) {
    try {
      new Quaternion(bad, 0, 0, bad);
      return false;
    } catch (ArithmeticException e) {
      return true;
    }
  }

  private static void drift(Tally tally) {
    Dice dice = new Dice(7);
    Vector3d eye = dice.unit().times(5);
    Vector3d up = dice.across(eye);
    Quaternion step = Quaternion.aboutAxis(dice.unit(), 0.37);
    Quaternion q = new Quaternion(1, 0, 0, 0);
    for (int i = 1; i <= 1_000_000; i++) {
      q = q.then(step);
      if (i % 10_000 == 0) {
        BigDecimal more = Four.of(q).dot(Four.of(q)).subtract(BigDecimal.ONE);
        tally.error(Math.abs(Exact.toDouble(more)) / 2 / Rounding.U);
        Transform turn = Transform.rotate(q);
        Camera camera =
            Camera.of(turn.point(eye), Vector3d.ZERO, turn.direction(up), Projection.vertical(90));
        CameraCases.frame(new View(camera, 2, 2), tally);
      }
    }
  }
}
