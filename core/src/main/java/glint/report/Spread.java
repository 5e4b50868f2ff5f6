package glint.report;

import java.util.Arrays;

/** The middle and the ends of some figures. */
public record Spread(double min, double median, double max) {

  /**
   * Returns the spread of at least one value; the median of an even number is the middle's mean.
   */
  public static Spread of(double... values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    int n = sorted.length;
    return new Spread(sorted[0], (sorted[(n - 1) / 2] + sorted[n / 2]) / 2, sorted[n - 1]);
  }
}
