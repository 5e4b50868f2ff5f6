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

  /** What is worth so many bins less is worth a quarter: the next step of a search. */
  private static final int QUARTER = 16;

  /** What is worth so many bins less than is done now, sixteen times, is left out of account. */
  private static final int MARGIN = 32;

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

  /** What is done with a pixel. */
  interface Work {

    /**
     * Refines a pixel.
     *
     * @param twice whether a search that goes on as foreseen is worth a second step at once
     */
    void refine(int pixel, boolean twice);
  }

  private final Film film;
  private final ErrorModel model;
  private final Hidden hidden;
  private final double[] gain = new double[BINS];
  private double total;
  private double margin;
  private int threshold;

  private final int[] all;

  /** The pixels that may be refined, in row order. */
  private int[] active;

  /** The variance of each of them, as the last {@link #total} found it. */
  private double[] variances = {};

  /** The bin of the next step of each of them. */
  private int[] next = {};

  /** The bin that others are below. */
  private int floor;

  /** The sum of the variances of all others, and that of their squares. */
  private double quiet;

  private double quietSquares;

  Allocation(Film film, ErrorModel model, Hidden hidden) {
    this.film = film;
    this.model = model;
    this.hidden = hidden;
    all = new int[film.kind.length];
    Arrays.setAll(all, pixel -> pixel);
    active = all;
  }

  /** Takes all pixels into account again: any may be worth more than before. */
  void wake() {
    active = all;
    quiet = 0;
    quietSquares = 0;
  }

  /**
   * Sorts out the unsampled smooth pixels that are worth far less than what is worth doing: they
   * stay as they are, and count as they do now.
   */
  private void sort() {
    floor = Math.max(1, threshold - MARGIN);
    int[] found = new int[active.length];
    int count = 0;
    for (int i = 0; i < active.length; i++) {
      int pixel = active[i];
      boolean plain = film.kind[pixel] == Film.SMOOTH && film.level[pixel] == 0;
      if (plain && next[i] < floor) {
        quiet += variances[i];
        quietSquares += variances[i] * variances[i];
      } else {
        next[count] = next[i];
        found[count++] = pixel;
      }
    }
    active = Arrays.copyOf(found, count);
  }

  /** Returns the pixels that were not sorted out. */
  int[] active() {
    return active;
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
    double sum = quiet;
    double squares = quietSquares;
    variances = active.length > variances.length ? new double[active.length] : variances;
    for (int i = 0; i < active.length; i++) {
      double variance = model.variance(active[i]);
      variances[i] = variance;
      sum += variance;
      squares += variance * variance;
    }
    total = sum;
    margin = total > 0 ? 1 + 2 * Math.sqrt(2 * squares) / total : 1;
    return margin * total;
  }

  /** Sets what is worth doing, to bring the last {@link #total} down to a goal. */
  void aim(double goal) {
    findThreshold(goal);
    if (threshold < floor) {
      wake();
      total();
      floor = 0;
      findThreshold(goal);
    }
    if (active == all) {
      sort();
    }
  }

  private void findThreshold(double goal) {
    Arrays.fill(gain, 0);
    double nothing = NOTHING * goal / film.kind.length;
    next = active.length > next.length ? new int[active.length] : next;
    for (int i = 0; i < active.length; i++) {
      next[i] = variances[i] > nothing ? foresee(active[i], variances[i], nothing) : 0;
    }
    double left = margin * total;
    threshold = BINS;
    while (threshold > 1 && left > goal) {
      threshold--;
      left -= margin * gain[threshold];
    }
  }

  /**
   * Gathers what the next steps gain, down to what is nothing; none counts for more than one before
   * it.
   *
   * @param now the pixel's variance, which is more
   * @return the bin of the first of them
   */
  private int foresee(int pixel, double now, double nothing) {
    double variance = now;
    double searched = searches(pixel) ? film.own[pixel] - film.doubt[pixel] : 0;
    double samples = film.samples(pixel);
    double doubled = model.doubled(pixel);
    int first = 0;
    int worth = BINS;
    for (int step = 0; step < STEPS && worth >= floor && variance > nothing; step++) {
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
      worth = Math.min(worth, bin(less / cost));
      first = step == 0 ? worth : first;
      gain[worth] += less;
      variance -= less;
    }
    return first;
  }

  /** Tells of every pixel that is to be refined now. */
  void forEachWorthy(Work work) {
    for (int i = 0; i < active.length; i++) {
      if (next[i] >= threshold) {
        work.refine(active[i], next[i] >= threshold + QUARTER);
      }
    }
  }

  /** Returns whether the next step is to find out better where the edge of a split pixel is. */
  boolean searches(int pixel) {
    if (film.kind[pixel] != Film.SPLIT || film.level[pixel] > 0) {
      return false;
    }
    double lasting = hidden.variance(pixel) + film.doubt[pixel];
    return film.own[pixel] - film.doubt[pixel] > SEARCHED * lasting;
  }

  private static int bin(double value) {
    return (int) (Double.doubleToRawLongBits(value) >>> BIN_SHIFT);
  }
}
