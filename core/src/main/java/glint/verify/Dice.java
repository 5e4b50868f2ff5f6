package glint.verify;

import glint.math.Vector3d;
import java.util.Random;

/** Random numbers, the same on every machine: from a fixed seed, by strict arithmetic. */
final class Dice {

  private final Random random;

  Dice(long seed) {
    random = new Random(seed);
  }

  /** Returns a number of a range. */
  double in(double least, double greatest) {
    return least + (greatest - least) * random.nextDouble();
  }

  /** Returns a positive number of a range, every order of magnitude as often as any other. */
  double log(double least, double greatest) {
    return least * StrictMath.pow(greatest / least, random.nextDouble());
  }

  /** Returns a whole number from 0 to n - 1. */
  int below(int n) {
    return random.nextInt(n);
  }

  /** Returns a power of two with an exponent from -range to range. */
  double power(int range) {
    return Math.scalb(1.0, random.nextInt(2 * range + 1) - range);
  }

  /** Returns 1 or -1. */
  double sign() {
    return random.nextBoolean() ? 1 : -1;
  }

  /** Returns a point of a cube around the origin. */
  Vector3d cube(double half) {
    return new Vector3d(in(-half, half), in(-half, half), in(-half, half));
  }

  /** Returns a point of a ball around the origin. */
  Vector3d ball(double radius) {
    while (true) {
      Vector3d v = cube(1);
      if (v.dot(v) <= 1) {
        return v.times(radius);
      }
    }
  }

  /** Returns a direction, all equally likely. */
  Vector3d unit() {
    while (true) {
      Vector3d v = cube(1);
      if (v.dot(v) <= 1 && v.dot(v) > 0x1p-20) {
        return v.normalized();
      }
    }
  }

  /** Returns a unit vector square to another, to within rounding. */
  Vector3d across(Vector3d axis) {
    Vector3d unit = axis.normalized();
    while (true) {
      Vector3d v = unit.cross(unit());
      if (v.dot(v) > 0x1p-10) {
        return v.normalized();
      }
    }
  }
}
