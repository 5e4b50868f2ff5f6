package glint.verify;

import java.math.BigDecimal;
import java.util.List;
import java.util.function.Predicate;

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
   * @param off how far the reported point lies from the surface
   */
  static double wrongness(
      List<Crossing> crossings, boolean found, double reported, double bound, double off) {
    if (!found) {
      return missing(crossings, c -> true);
    }
    BigDecimal t = Exact.of(reported);
    double least = Math.max(off, missing(crossings, c -> c.isBefore(t, bound)));
    for (Crossing c : crossings) {
      if (c.errorOf(reported) <= bound) {
        double skipped = missing(crossings, other -> other.t.compareTo(c.t) < 0);
        least = Math.min(least, Math.max(-c.certainty(), skipped));
      }
    }
    return Math.max(0, least);
  }

  /** Returns how wrong a decision is about a surface without straight lines. */
  static double wrongness(List<Crossing> crossings, boolean found, double reported, double bound) {
    return wrongness(crossings, found, reported, bound, Double.POSITIVE_INFINITY);
  }

  /** How certain the surest of some crossings is. */
  private static double missing(List<Crossing> crossings, Predicate<Crossing> which) {
    return crossings.stream().filter(which).mapToDouble(Crossing::certainty).reduce(0, Math::max);
  }

  private boolean isBefore(BigDecimal end, double bound) {
    return t.compareTo(end) < 0 && errorOf(end.doubleValue()) > bound;
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
