package glint.verify;

import glint.verify.HardCase.Effort;

/** Counts the trials of one case, and keeps the largest error. */
final class Tally {

  private final Effort effort;
  private long tried;
  private long wrong;
  private double worst;

  Tally(Effort effort) {
    this.effort = effort;
  }

  /** Returns how often to try, by effort. */
  int times(int little, int much) {
    return effort == Effort.SHORT ? little : much;
  }

  /** Counts a trial with a right or a wrong answer. */
  void check(boolean right) {
    tried++;
    if (!right) {
      wrong++;
    }
  }

  /** Notes the size of an error; NaN sticks. */
  void error(double size) {
    worst = Math.max(worst, size);
  }

  long tried() {
    return tried;
  }

  long wrong() {
    return wrong;
  }

  double worst() {
    return worst;
  }
}
