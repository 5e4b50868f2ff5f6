package glint.verify;

import glint.math.Vector3d;
import java.math.BigDecimal;

/** A point or direction without any rounding; immutable. */
record Exact3(BigDecimal x, BigDecimal y, BigDecimal z) {

  static Exact3 of(Vector3d v) {
    return of(v.x(), v.y(), v.z());
  }

  static Exact3 of(double x, double y, double z) {
    return new Exact3(Exact.of(x), Exact.of(y), Exact.of(z));
  }

  Exact3 plus(Exact3 v) {
    return new Exact3(x.add(v.x), y.add(v.y), z.add(v.z));
  }

  Exact3 minus(Exact3 v) {
    return new Exact3(x.subtract(v.x), y.subtract(v.y), z.subtract(v.z));
  }

  Exact3 times(BigDecimal s) {
    return new Exact3(x.multiply(s), y.multiply(s), z.multiply(s));
  }

  BigDecimal dot(Exact3 v) {
    return x.multiply(v.x).add(y.multiply(v.y)).add(z.multiply(v.z));
  }

  BigDecimal squared() {
    return dot(this);
  }

  Exact3 cross(Exact3 v) {
    return new Exact3(
        y.multiply(v.z).subtract(z.multiply(v.y)),
        z.multiply(v.x).subtract(x.multiply(v.z)),
        x.multiply(v.y).subtract(y.multiply(v.x)));
  }

  /** Returns the length to double precision. */
  double length() {
    return Math.sqrt(Exact.toDouble(squared()));
  }

  /** Returns the nearest vector of doubles. */
  Vector3d toDoubles() {
    return new Vector3d(Exact.toDouble(x), Exact.toDouble(y), Exact.toDouble(z));
  }
}
