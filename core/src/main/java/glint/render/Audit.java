package glint.render;

import glint.sampling.SobolSampler;
import java.util.Arrays;

/** Samples a few pixels of every kind, to learn what their models get wrong. */
final class Audit {

  /** Of how many pixels one is audited: split or veiled ones, smooth ones beside edges, others. */
  private static final int SPLIT = 12;

  private static final int BESIDE = 24;
  private static final int ALONE = 96;

  /** That is so in an image of so many pixels; audits are as many as its square root. */
  private static final double USUAL = 20_000;

  /** Samples of an audit that has found something, as a power of two. */
  private static final int SECOND_LOOK = 4;

  /** Up to how many times its variance a squared error is no surprise. */
  private static final double EXPLAINED = 9;

  private final Film film;
  private final ErrorModel model;
  private final Hidden hidden;
  private final LevelScale scale;
  private final Sampling sampling;
  private final long seed;
  private final OneIn split;
  private final OneIn beside;
  private final OneIn alone;

  Audit(
      Film film, ErrorModel model, Hidden hidden, LevelScale scale, Sampling sampling, long seed) {
    this.film = film;
    this.model = model;
    this.hidden = hidden;
    this.scale = scale;
    this.sampling = sampling;
    this.seed = SobolSampler.mix(seed);
    split = rarer(SPLIT);
    beside = rarer(BESIDE);
    alone = rarer(ALONE);
  }

  private OneIn rarer(int usual) {
    return new OneIn(Math.max(1, (int) (Math.sqrt(film.kind.length / USUAL) * usual)));
  }

  /** Audits; another number chooses other pixels. */
  void run(int number) throws InterruptedException {
    for (int pixel = 0; pixel < film.kind.length; pixel++) {
      if (film.kind[pixel] != Film.BUSY && film.level[pixel] == 0 && isChosen(pixel, number)) {
        sampling.choose(pixel);
      }
    }
    int[] pixels = sampling.chosen();
    int[] groups = new int[pixels.length];
    double[] known = new double[pixels.length];
    double[] values = new double[3 * pixels.length];
    for (int i = 0; i < pixels.length; i++) {
      groups[i] = hidden.group(pixels[i]);
      known[i] = film.own[pixels[i]];
      System.arraycopy(film.image.rgb(), 3 * pixels[i], values, 3 * i, 3);
    }
    sampling.run();
    Arrays.stream(pixels).filter(film::foundMore).forEach(sampling::choose);
    sampling.run(SECOND_LOOK);
    hidden.forget();
    model.learn();
    for (int i = 0; i < pixels.length; i++) {
      double wrong = 0;
      for (int channel = 0; channel < 3; channel++) {
        double now = film.image.rgb()[3 * pixels[i] + channel];
        wrong += scale.squaredDifference(now, values[3 * i + channel]) / 3;
      }
      hidden.audit(pixels[i], groups[i], wrong - known[i] - model.sampled(pixels[i]));
      // An edge that is where it was thought to be is cheaper searched than sampled.
      if (film.kind[pixels[i]] == Film.SPLIT && wrong <= EXPLAINED * known[i]) {
        film.forget(pixels[i]);
      }
    }
  }

  private boolean isChosen(int pixel, int number) {
    OneIn smooth = film.surroundings[pixel] > 0 ? beside : alone;
    OneIn some = film.kind[pixel] == Film.SPLIT || film.veiled[pixel] ? split : smooth;
    return some.takes(SobolSampler.mix(seed ^ ((long) number << 32 | pixel)));
  }
}
