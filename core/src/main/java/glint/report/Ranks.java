package glint.report;

import java.util.Arrays;
import java.util.Comparator;

/** Ranks of values: 1 for the smallest. */
final class Ranks {

  private Ranks() {}

  /** Returns the rank of every value; equal values share the mean of their ranks. */
  static double[] of(double[] values) {
    int[] order = order(values);
    double[] ranks = new double[values.length];
    int from = 0;
    while (from < order.length) {
      int to = from;
      while (to < order.length && values[order[to]] == values[order[from]]) {
        to++;
      }
      for (int i = from; i < to; i++) {
        ranks[order[i]] = (from + 1 + to) / 2.0;
      }
      from = to;
    }
    return ranks;
  }

  /** Returns the places of the values from the smallest to the largest, equal ones in order. */
  static int[] order(double[] values) {
    Integer[] places = new Integer[values.length];
    Arrays.setAll(places, i -> i);
    Arrays.sort(places, Comparator.comparingDouble(i -> values[i]));
    return Arrays.stream(places).mapToInt(i -> i).toArray();
  }
}
