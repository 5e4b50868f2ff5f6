package glint.report;

import java.util.Arrays;
import java.util.Random;
import java.util.function.ToDoubleFunction;

/** Where a figure lies with a confidence of 95 %. */
public record Interval(double low, double high) {

  private static final int RESAMPLES = 1000;

  /**
   * Finds the interval by the percentile bootstrap: the figure is computed anew from as many runs
   * as there were, drawn with replacement, a thousand times. The draws are always the same.
   *
   * <p>Source: B. Efron, R. Tibshirani, An Introduction to the Bootstrap, 1993, ch. 13.
   *
   * @param runs how many runs there are
   * @param figure computes the figure from the numbers of the runs drawn; draws of which it makes
   *     NaN do not count
   */
  public static Interval bootstrap(int runs, ToDoubleFunction<int[]> figure) {
    Random random = new Random(0);
    int[] drawn = new int[runs];
    double[] figures = new double[RESAMPLES];
    int count = 0;
    for (int i = 0; i < RESAMPLES; i++) {
      for (int j = 0; j < runs; j++) {
        drawn[j] = random.nextInt(runs);
      }
      double value = figure.applyAsDouble(drawn);
      if (!Double.isNaN(value)) {
        figures[count++] = value;
      }
    }
    if (count == 0) {
      return new Interval(Double.NaN, Double.NaN);
    }
    Arrays.sort(figures, 0, count);
    int tail = (int) (0.025 * count);
    return new Interval(figures[tail], figures[count - 1 - tail]);
  }
}
