package glint.render;

/**
 * Estimates the variance of every pixel's mean, in levels²; learns what it needs from the very
 * image at hand.
 *
 * <p>Samples are spread evenly, so their mean is better than that of independent ones, by how much
 * depends on the image. With V(n) the variance of the mean of n samples of one scrambled sequence,
 * the mean moves by V(n/2) - V(n), squared and on average, when their number doubles; where V falls
 * like n^-1.5, as it does at edges, V(n) is that over 2^1.5 - 1; of random samples, how moves fall
 * from doubling to doubling tells the exponent. Summed over all pixels with n samples, this says
 * how much better they are than independent ones.
 */
final class ErrorModel {

  /** Claims are so many times what models expect of the error; found on many scenes. */
  static final double CALIBRATION = 1.2;

  /** V(n/2) over V(n) at edges, less one. */
  private static final double FALL = 2 * Math.sqrt(2) - 1;

  /** The least of it: samples are no worse than independent ones. */
  private static final double LEAST_FALL = 1;

  /** As how many pixels it counts that random samples become better like those at edges. */
  private static final int EDGES = 50;

  /**
   * By how much even samples are usually better than independent ones, times the root of their
   * number: where all of a pixel is sampled, and where samples look for the little that a model has
   * wrong.
   */
  private static final double SAMPLED = 1;

  private static final double MODELLED = 1.6;

  /** Levels of doubling. */
  private static final int LEVELS = 32;

  /** So many for smooth, split and busy pixels, and for those with random samples. */
  private static final int KINDS = 4 * LEVELS;

  private static final int RANDOM = 3 * LEVELS;

  /** As how many pixels it counts that models are as wrong as they say themselves. */
  private static final int DISTRUST = 50;

  /** As how many samples those around a pixel count where they are random. */
  private static final double AROUND = 3;

  private final Film film;
  private final Hidden hidden;
  private final double[] moved = new double[KINDS];
  private final double[] spread = new double[KINDS];
  private final int[] pixels = new int[KINDS];
  private final double[] gain = new double[KINDS];
  private final double[] doubted = new double[KINDS];
  private final double[] trust = new double[KINDS];
  private double randomFall;

  /**
   * Makes a model that has learned nothing yet.
   *
   * @param hidden what it adds to the variance of unsampled pixels; learns when this does
   */
  ErrorModel(Film film, Hidden hidden) {
    this.film = film;
    this.hidden = hidden;
    learn();
  }

  /** Notes how far the mean of a pixel moved with its last doubling, squared. */
  void note(int pixel, double squared) {
    int kind = kind(pixel);
    moved[kind] += squared;
    spread[kind] += spread(pixel);
    doubted[kind] += film.kind[pixel] == Film.BUSY ? 0 : missed(pixel);
    pixels[kind]++;
  }

  /** Draws conclusions from what was noted; call it after notes, before estimates. */
  void learn() {
    randomFall = findRandomFall();
    for (int kind = 0; kind < KINDS; kind++) {
      double usual = kind < LEVELS * Film.BUSY ? MODELLED : SAMPLED;
      double expected = Math.min(1, usual / Math.sqrt(Math.scalb(1.0, kind % LEVELS)));
      double weight = pixels[kind] == 0 ? 1 : 20 * spread[kind] / pixels[kind];
      double total = spread[kind] + weight;
      double steep = kind < RANDOM ? FALL : randomFall;
      gain[kind] = total > 0 ? (moved[kind] / steep + weight * expected) / total : expected;
    }
    for (int kind = KINDS - 2; kind >= RANDOM; kind--) {
      foresee(kind);
    }
    for (int kind = 0; kind < KINDS; kind++) {
      double found = doubted[kind] > 0 ? gain[kind] * spread[kind] / doubted[kind] : 1;
      trust[kind] = (pixels[kind] * found + 2 * DISTRUST) / (pixels[kind] + DISTRUST);
    }
    hidden.learn();
  }

  /**
   * Corrects the gain of random samples by those with twice as many: V(n) is their move and V(2n).
   */
  private void foresee(int kind) {
    double next = spread[kind + 1] > 0 ? moved[kind + 1] / spread[kind + 1] : 0;
    double share = pixels[kind + 1] / (double) (pixels[kind + 1] + EDGES);
    gain[kind] += share * (0.5 * (next + gain[kind + 1]) - gain[kind]);
  }

  /**
   * Finds V(n/2) over V(n), less one, of random samples. With V falling like n^-p, moves compared
   * with what independent samples would make of them fall like n^(1-p), from doubling to doubling.
   * The first moves are another matter: they show what is even in the pixel.
   */
  private double findRandomFall() {
    double sum = EDGES * -0.5;
    double weights = EDGES;
    for (int kind = RANDOM + Refiner.FIRST + 2; kind < KINDS; kind++) {
      if (moved[kind] > 0 && moved[kind - 1] > 0 && spread[kind] > 0 && spread[kind - 1] > 0) {
        double before = moved[kind - 1] / spread[kind - 1];
        double weight = Math.min(pixels[kind], pixels[kind - 1]);
        sum += weight * StrictMath.log(moved[kind] / spread[kind] / before) / StrictMath.log(2);
        weights += weight;
      }
    }
    double fall = StrictMath.pow(2, 1 - sum / weights) - 1;
    return Math.min(Math.max(fall, LEAST_FALL), FALL);
  }

  /** Returns what is left of a sampled pixel's variance after twice as many samples. */
  double doubled(int pixel) {
    return 1 / (1 + (film.random[pixel] ? randomFall : FALL));
  }

  /** Returns the estimate of a pixel's variance. */
  double variance(int pixel) {
    if (film.level[pixel] == 0) {
      return film.own[pixel] + hidden.variance(pixel);
    }
    if (film.kind[pixel] == Film.BUSY) {
      return sampled(pixel) + surprise(pixel);
    }
    return 0.5 * (sampled(pixel) + trust[kind(pixel)] * missed(pixel)) + hidden.escaped(pixel);
  }

  /** Returns the variance of a sampled pixel's mean as its samples tell it. */
  double sampled(int pixel) {
    return gain[kind(pixel)] * spread(pixel);
  }

  private int kind(int pixel) {
    if (film.random[pixel]) {
      return RANDOM + film.level[pixel];
    }
    return LEVELS * film.kind[pixel] + film.level[pixel];
  }

  /**
   * Returns the variance of a mean of as many independent samples. To those of a pixel without a
   * model, one of the contrast around is added: they may all have missed something.
   */
  private double spread(int pixel) {
    double n = film.samples(pixel);
    if (film.kind[pixel] != Film.BUSY) {
      return (n - 1) * film.own[pixel] / n;
    }
    double count = film.random[pixel] ? n + AROUND : n;
    return ((n - 1) * film.own[pixel] + film.contrast[pixel] / n) / count;
  }

  /**
   * Returns the variance of what samples around a pixel, or its corners, have found and its own
   * have not: a pixel that a few samples take for even would not be looked at again. No even
   * sequence makes that less.
   */
  private double surprise(int pixel) {
    double n = film.samples(pixel);
    double more = film.noise[pixel] - n * film.own[pixel];
    return more > 0 ? more / (n * (n + AROUND)) : 0;
  }

  /**
   * Returns the variance that is left of what a model says of itself where samples find nothing
   * wrong with it: an area a of the pixel, where colours differ by about twice the contrast,
   * escapes n samples with a probability like exp(-na), so that a² may still be about 1/n². On
   * average over pixels it is as much as samples do find.
   */
  private double missed(int pixel) {
    double n = film.samples(pixel);
    double known = film.prior[film.slot[pixel]];
    return known / (1 + n * n * known / (4 * hidden.contrast(pixel)));
  }
}
