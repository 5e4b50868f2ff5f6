package glint.verify;

import java.math.BigDecimal;
import java.util.List;

/**
 * A place where a line crosses a surface, or barely fails to.
 *
 * @param t the exact parameter, to sixty digits
 * @param unit the error of t that an error of u·S across the ray may cause, S being distance plus
 *     size
 * @param inside how far the line is from missing the surface here, in units of u·S; below 0 it does
 *     miss
 */
record Crossing(BigDecimal t, double unit, double inside) {

  /** Returns how far this is from not being a hit: of the line, and in front of the origin. */
  private double certainty() {
    int side = t.signum();
    double depth = unit > 0 ? Exact.toDouble(t) / unit : side * Double.POSITIVE_INFINITY;
    return side == 0 ? -Double.MAX_VALUE : Math.min(inside, depth);
  }

  /** Returns by how many units a reported parameter is off. */
  double errorOf(double reported) {
    BigDecimal error = Exact.of(reported).subtract(t).abs();
    return error.signum() == 0 ? 0 : Exact.toDouble(error) / unit;
  }

  /**
   * Returns how wrong a decision is: 0 if it is right, else the distance, in u·S, by which the ray
   * would have to pass elsewhere to make it right.
   *
   * @param found whether a hit was reported
   * @param reported its parameter
   * @param bound how many units a reported parameter may be off to mean a crossing
   */
  static double wrongness(List<Crossing> crossings, boolean found, double reported, double bound) {
    if (!found) {
      return missing(crossings, null);
    }
    double least = Double.POSITIVE_INFINITY;
    for (Crossing c : crossings) {
      if (c.errorOf(reported) <= bound) {
        least = Math.min(least, Math.max(-c.certainty(), missing(crossings, c)));
      }
    }
    return Math.max(0, least);
  }

  /** How certain the surest crossing is that comes before another one, or before the end. */
  private static double missing(List<Crossing> crossings, Crossing end) {
    double surest = 0;
    for (Crossing c : crossings) {
      if (end == null || c.t.compareTo(end.t) < 0) {
        surest = Math.max(surest, c.certainty());
      }
    }
    return surest;
  }

  /** Returns the error of a reported parameter in units, or 0 if the line misses exactly. */
  static double error(List<Crossing> crossings, double reported) {
    double least = Double.POSITIVE_INFINITY;
    boolean misses = true;
    for (Crossing c : crossings) {
      least = Math.min(least, c.errorOf(reported));
      misses &= c.inside < 0;
    }
    return misses ? 0 : least;
  }
}
