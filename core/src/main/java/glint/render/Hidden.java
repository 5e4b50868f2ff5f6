package glint.render;

import java.util.Arrays;

/**
 * What the models of unsampled pixels know nothing of, learned from audits: samples of a few pixels
 * of every kind and surroundings, in relation to the contrast around them.
 */
final class Hidden {

  /**
   * Kinds times surroundings, where smooth pixels in several shadows, and those found from images,
   * are kinds of their own.
   */
  private static final int GROUPS = 64;

  private static final int VEILED = 32;
  private static final int INLAID = 48;

  /** The area, as a share of the pixel, of a typical thing that a model knows nothing of. */
  private static final double AREA = 0.15;

  /**
   * What models get wrong before any audit, in relation to the contrast around, squared: of smooth
   * pixels, it is less in nineteen of twenty images.
   */
  private static final double FIRST_GUESS = 0.0002;

  /** As how many audits that guess counts. */
  private static final int GUESSED = 10;

  /** Added to contrasts: what is worth a level. */
  private static final double LEAST_CONTRAST = 1;

  private final Film film;
  private final double[] wrong = new double[GROUPS];
  private final double[] contrast = new double[GROUPS];
  private final int[] audits = new int[GROUPS];
  private final double[] ratio = new double[GROUPS];

  Hidden(Film film) {
    this.film = film;
    learn();
  }

  /** Returns the kind and surroundings of an unsampled pixel that has a model. */
  int group(int pixel) {
    int plain = film.inlaid[pixel] ? INLAID : 16 * film.kind[pixel];
    return (film.veiled[pixel] ? VEILED : plain) + film.surroundings[pixel];
  }

  /**
   * Notes an audit.
   *
   * @param group of the pixel, as {@link #group} gave it
   * @param squared by how much the model was wrong, squared, less what is known to explain it
   */
  void audit(int pixel, int group, double squared) {
    wrong[group] += squared;
    contrast[group] += contrast(pixel);
    audits[group]++;
  }

  /** Forgets what earlier audits found: pixels that are left now may be others. */
  void forget() {
    Arrays.fill(wrong, 0);
    Arrays.fill(contrast, 0);
    Arrays.fill(audits, 0);
  }

  /** Draws conclusions from the audits; call it after them, before estimates. */
  void learn() {
    for (int first = 0; first < GROUPS; first += 16) {
      double allWrong = 0;
      double allContrast = 0;
      int all = 0;
      for (int group = first; group < first + 16; group++) {
        allWrong += wrong[group];
        allContrast += contrast[group];
        all += audits[group];
      }
      double guess = all == 0 ? 1 : GUESSED * allContrast / all;
      double common = (allWrong + FIRST_GUESS * guess) / (allContrast + guess);
      for (int group = first; group < first + 16; group++) {
        double weight = audits[group] == 0 ? 1 : GUESSED * contrast[group] / audits[group];
        double mean = (wrong[group] + weight * common) / (contrast[group] + weight);
        ratio[group] = Math.max(0, mean);
      }
    }
  }

  /** Returns the part of the variance of an unsampled pixel that its model knows nothing of. */
  double variance(int pixel) {
    return film.kind[pixel] == Film.BUSY ? 0 : ratio[group(pixel)] * contrast(pixel);
  }

  /**
   * Returns what is left of that in a sampled pixel. What is hidden in an area a of the pixel
   * escapes n even samples while na is below one, and hardly ever after that. Light between shadows
   * falls on areas of any size: it is those of about 1/n, and squares of them, that are left.
   */
  double escaped(int pixel) {
    double found = film.samples(pixel) * AREA;
    double squared = found * found;
    return variance(pixel) / (1 + (film.veiled[pixel] ? squared : squared * squared));
  }

  /** Returns the contrast around a pixel, in levels², which is never nothing. */
  double contrast(int pixel) {
    return film.contrast[pixel] + LEAST_CONTRAST;
  }
}
