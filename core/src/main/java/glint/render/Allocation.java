package glint.render;

import java.util.Arrays;

/**
 * Shares out work: chooses the pixels whose next refinement takes away most error for its rays, and
 * so few of them that the error comes down to a goal.
 *
 * <p>Equal gain for equal cost everywhere is the cheapest way there. The gains of all steps that
 * are foreseen are gathered in bins, eight to an octave.
 */
final class Allocation {

  private static final int BIN_SHIFT = 49;
  private static final int BINS = 1 << 63 - BIN_SHIFT;

  /** Steps foreseen for a pixel. */
  private static final int STEPS = 16;

  /** The same after the first samples. */
  private static final double SAMPLED = 0.3;

  /** The same where an edge is known twice as well. */
  private static final double HALVED = 0.25;

  /** Pixels of so small a share of the variance accepted need not be refined for it. */
  private static final double NOTHING = 0.01;

  /** An edge is searched while its variance is more than this share of what it leaves. */
  private static final double SEARCHED = 0.2;

  private final Film film;
  private final ErrorModel model;
  private final double[] gain = new double[BINS];
  private double total;
  private double margin;
  private int threshold;

  Allocation(Film film, ErrorModel model) {
    this.film = film;
    this.model = model;
  }

  /**
   * Estimates the sum of all pixels' squared errors, and what it can hardly exceed: few pixels that
   * err much may be unlucky together. The variance of a square is at most twice that of a normal
   * error, V² each; of the sum, which is skewed, 2 standard deviations keep it in 95 % of all
   * images.
   *
   * @return the sum that will hardly be exceeded, in levels²
   */
  double total() {
    total = 0;
    double squares = 0;
    for (int pixel = 0; pixel < film.kind.length; pixel++) {
      double variance = model.variance(pixel);
      total += variance;
      squares += variance * variance;
    }
    margin = total > 0 ? 1 + 2 * Math.sqrt(2 * squares) / total : 1;
    return margin * total;
  }

  /** Sets what is worth doing, to bring the last {@link #total} down to a goal. */
  void aim(double goal) {
    Arrays.fill(gain, 0);
    double nothing = NOTHING * goal / film.kind.length;
    for (int pixel = 0; pixel < film.kind.length; pixel++) {
      double variance = model.variance(pixel);
      if (variance > nothing) {
        foresee(pixel, variance);
      }
    }
    double left = margin * total;
    threshold = BINS;
    while (threshold > 1 && left > goal) {
      threshold--;
      left -= margin * gain[threshold];
    }
  }

  /** Gathers what the next steps gain; none counts for more than one before it. */
  private void foresee(int pixel, double now) {
    double variance = now;
    double searched = searches(pixel) ? film.own[pixel] - film.doubt[pixel] : 0;
    double samples = film.samples(pixel);
    double doubled = model.doubled(pixel);
    double worth = Double.POSITIVE_INFINITY;
    for (int step = 0; step < STEPS && variance > 0; step++) {
      double less;
      double cost;
      if (searched > SEARCHED * (variance - searched)) {
        less = searched * (1 - HALVED);
        cost = 1;
        searched -= less;
      } else if (samples == 0) {
        samples = 1 << Refiner.FIRST;
        cost = samples;
        less = variance * (1 - SAMPLED);
      } else {
        cost = samples;
        samples *= 2;
        less = variance * (1 - doubled);
      }
      worth = Math.min(worth, less / cost);
      gain[bin(worth)] += less;
      variance -= less;
    }
  }

  /** Returns whether a pixel is to be refined now. */
  boolean worth(int pixel) {
    double less = model.variance(pixel) * (1 - rest(pixel));
    return less > 0 && bin(less / cost(pixel)) >= threshold;
  }

  /** Returns whether the next step is to find out better where the edge of a split pixel is. */
  boolean searches(int pixel) {
    return film.kind[pixel] == Film.SPLIT
        && film.level[pixel] == 0
        && film.own[pixel] - film.doubt[pixel] > SEARCHED * lasting(pixel);
  }

  /** Returns the part of the variance of a split pixel that searching for its edge leaves. */
  private double lasting(int pixel) {
    return model.hidden(pixel) + film.doubt[pixel];
  }

  private double cost(int pixel) {
    if (film.level[pixel] > 0) {
      return film.samples(pixel);
    }
    return searches(pixel) ? 1 : 1 << Refiner.FIRST;
  }

  private double rest(int pixel) {
    if (film.level[pixel] > 0) {
      return model.doubled(pixel);
    }
    if (!searches(pixel)) {
      return SAMPLED;
    }
    double lasting = lasting(pixel);
    double searched = film.own[pixel] - film.doubt[pixel];
    return (HALVED * searched + lasting) / (searched + lasting);
  }

  private static int bin(double value) {
    return (int) (Double.doubleToRawLongBits(value) >>> BIN_SHIFT);
  }
}
