package glint.report;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How well the errors that are claimed of pixels agree with their true errors.
 *
 * <p>Pixels without any error, claimed or true, are counted and otherwise left aside: there are
 * often many, and they would hide how the others do.
 *
 * @param pixels how many pixels there are
 * @param flat how many of them have no error, claimed or true
 * @param ratio root mean square of the claimed errors over that of the true ones: above 1 claims
 *     are too careful, below 1 too bold
 * @param coverage the shares of pixels whose true error is at most 1, 2 and 3 times the claimed
 *     one; 0.683, 0.954 and 0.997 for standard errors of a normal distribution
 * @param spearman the correlation of the ranks of claimed and true errors: 1 where more is claimed
 *     wherever more is true; NaN if all of either are equal
 * @param silentMisses pixels that claim less than the threshold and err by more
 * @param reliability the pixels by growing claims, in ten bins of as many
 */
public record Calibration(
    int pixels,
    int flat,
    double ratio,
    List<Double> coverage,
    double spearman,
    int silentMisses,
    List<Bin> reliability) {

  private static final int BINS = 10;
  private static final int SIGMAS = 3;

  /** Pixels with claims alike: root mean squares of what they claim and of what is true. */
  public record Bin(int pixels, double claimed, double actual) {}

  /**
   * Compares claims with the truth.
   *
   * @param claimed the standard error that each pixel claims, in display levels, at least 0
   * @param actual its true error, in display levels, at least 0
   * @param threshold the error above which a pixel should not have been silent
   * @throws IllegalArgumentException if there are not as many of both
   */
  public static Calibration of(double[] claimed, double[] actual, double threshold) {
    if (claimed.length != actual.length) {
      throw new IllegalArgumentException(claimed.length + " claims of " + actual.length);
    }
    int[] active =
        IntStream.range(0, claimed.length)
            .filter(i -> Math.max(claimed[i], actual[i]) > Curve.NONE)
            .toArray();
    double[] c = pick(claimed, active);
    double[] a = pick(actual, active);
    List<Double> coverage = new ArrayList<>();
    for (int sigma = 1; sigma <= SIGMAS; sigma++) {
      coverage.add(covered(c, a, sigma));
    }
    return new Calibration(
        claimed.length,
        claimed.length - active.length,
        rms(c, 0, c.length) / rms(a, 0, a.length),
        List.copyOf(coverage),
        correlation(Ranks.of(c), Ranks.of(a)),
        (int)
            IntStream.range(0, c.length).filter(i -> c[i] < threshold && a[i] > threshold).count(),
        bins(c, a));
  }

  private static double covered(double[] claimed, double[] actual, int sigma) {
    int covered = 0;
    for (int i = 0; i < claimed.length; i++) {
      if (actual[i] <= sigma * claimed[i]) {
        covered++;
      }
    }
    return (double) covered / claimed.length;
  }

  private static List<Bin> bins(double[] claimed, double[] actual) {
    int[] order = Ranks.order(claimed);
    double[] c = pick(claimed, order);
    double[] a = pick(actual, order);
    List<Bin> bins = new ArrayList<>();
    for (int bin = 0; bin < BINS; bin++) {
      int from = (int) ((long) c.length * bin / BINS);
      int to = (int) ((long) c.length * (bin + 1) / BINS);
      if (to > from) {
        bins.add(new Bin(to - from, rms(c, from, to), rms(a, from, to)));
      }
    }
    return List.copyOf(bins);
  }

  private static double rms(double[] values, int from, int to) {
    double sum = 0;
    for (int i = from; i < to; i++) {
      sum += values[i] * values[i];
    }
    return Math.sqrt(sum / (to - from));
  }

  /** Returns Pearson's coefficient of two sets of ranks, which have the same mean, exactly. */
  private static double correlation(double[] x, double[] y) {
    double mean = (x.length + 1) / 2.0;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (int i = 0; i < x.length; i++) {
      xx += (x[i] - mean) * (x[i] - mean);
      xy += (x[i] - mean) * (y[i] - mean);
      yy += (y[i] - mean) * (y[i] - mean);
    }
    return xy / Math.sqrt(xx * yy);
  }

  private static double[] pick(double[] values, int[] places) {
    return IntStream.of(places).mapToDouble(i -> values[i]).toArray();
  }
}
