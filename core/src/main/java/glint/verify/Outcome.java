package glint.verify;

/**
 * What running a hard case found: one row of {@code glint verify}.
 *
 * @param id the case's identifier, such as S05
 * @param what what was tried, in one line
 * @param tried how many single trials there were
 * @param wrong how many had the wrong answer
 * @param worst the largest error met, in {@code unit}; 0 where answers are only right or wrong
 * @param bound what {@code worst} may be at most
 * @param unit the unit of worst and bound, such as "ulp" or "u·S"
 */
public record Outcome(
    String id, String what, long tried, long wrong, double worst, double bound, String unit) {

  /** Returns whether every answer was right and no error beyond its bound. */
  public boolean passed() {
    return tried > 0 && wrong == 0 && worst <= bound;
  }
}
