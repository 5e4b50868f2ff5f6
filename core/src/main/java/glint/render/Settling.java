package glint.render;

import glint.color.Transfer;
import glint.image.Image;
import glint.sampling.SobolSampler;

/**
 * Estimates the error of an image of as many samples for every pixel: from how far the pixels'
 * means moved when their samples doubled for the last time, and the time before.
 *
 * <p>With V(n) the variance of a mean of n samples of one scrambled sequence, the mean moves by
 * V(n/2) - V(n), squared and on average, when their number doubles. Summed over all pixels, two
 * such moves tell how fast V falls: like n^-p, with p about 1.5 at edges; and with that, what is
 * left of it.
 *
 * <p>A single sample moves nothing. Its error is told from second differences between neighbours: a
 * step leaves two of them in a row or column, each as large as itself, and as it may be anywhere
 * between two pixels' centres, a mean squared error of about a twelfth of its square.
 */
final class Settling {

  /** A quarter of the samples (of the power of two below), half, and that power. */
  static final int STAGES = 3;

  /** So many pixels at least, of an image that has them, tell its error; more would take time. */
  private static final int WATCHED = 1 << 13;

  /** How V falls where nothing else is known: at edges. */
  private static final double FALL = 1.5;

  /** Between which bounds it falls: as if samples were random, and where nothing has an edge. */
  private static final double LEAST_FALL = 1;

  private static final double MOST_FALL = 3;

  /** The same of the first sample and the second, which lies about opposite. */
  private static final double FIRST_FALL = 2;

  /** The variance of a second difference's square: half a twelfth. */
  private static final double STEP = 1 / 24.0;

  /** A sum exceeds its mean by so many standard deviations in 5 % of cases. */
  private static final double HARDLY = 1.65;

  private final int samples;
  private final Image image;
  private final LevelScale scale;

  /** By pixel: the square of its mean's last move; in the end its variance; in levels². */
  private final float[] last;

  /** The square of the last move but one. */
  private final float[] before;

  /** Which bits of a pixel's hash are zero where it is watched for the estimate of the image. */
  private final long mask;

  private final boolean everywhere;

  /**
   * Sets up the estimate of an image that is about to be rendered.
   *
   * @param everywhere whether the errors of single pixels are asked for
   */
  Settling(int samples, Image image, Transfer transfer, boolean everywhere) {
    this.everywhere = everywhere;
    this.samples = samples;
    this.image = image;
    scale = LevelScale.of(transfer);
    last = new float[image.width() * image.height()];
    before = new float[samples < 4 ? 0 : last.length];
    mask = Integer.highestOneBit(Math.max(1, last.length / WATCHED)) - 1;
  }

  /** Returns with how many samples of a pixel a stage ends. */
  int end(int stage) {
    return Integer.highestOneBit(samples) >> STAGES - 1 - stage;
  }

  /** Notes how far the mean of a pixel has moved in a stage; {@code levels} is scratch for 3. */
  void note(int stage, int pixel, PixelSampler sampler, double[] levels) {
    if (end(stage) > 0) {
      double moved = move(sampler, levels);
      if (stage == 1 && before.length > 0) {
        before[pixel] = (float) moved;
      } else if (stage == 2) {
        last[pixel] = (float) moved;
      }
    }
  }

  /** Returns whether the moves of a pixel's mean are noted. */
  boolean isNoted(int pixel) {
    return samples > 1 && (everywhere || isWatched(pixel));
  }

  private boolean isWatched(int pixel) {
    return (SobolSampler.mix(pixel) & mask) == 0;
  }

  /** Returns by how much the mean has moved, squared. */
  private double move(PixelSampler sampler, double[] levels) {
    double r = levels[0];
    double g = levels[1];
    double b = levels[2];
    boolean any = sampler.valid() > 0;
    levels[0] = any ? scale.level(sampler.r()) : 0;
    levels[1] = any ? scale.level(sampler.g()) : 0;
    levels[2] = any ? scale.level(sampler.b()) : 0;
    double dr = levels[0] - r;
    double dg = levels[1] - g;
    double db = levels[2] - b;
    return (dr * dr + dg * dg + db * db) / 3;
  }

  /** Makes variances of what was noted; call it once, when the image is finished. */
  void conclude() {
    if (samples == 1) {
      bend();
      return;
    }
    double fall = fall();
    double left = left(fall) / (StrictMath.pow(2, fall) - 1);
    double back = StrictMath.pow(2, -fall);
    for (int pixel = 0; pixel < last.length; pixel++) {
      double move = last[pixel];
      if (before.length > 0) {
        move = 0.5 * (move + back * before[pixel]);
      }
      last[pixel] = (float) (left * move);
    }
  }

  /** Returns the estimate of the image's RMS error, in levels. */
  double error() {
    double sum = 0;
    double squares = 0;
    int count = 0;
    for (int pixel = 0; pixel < last.length; pixel++) {
      if (isWatched(pixel)) {
        double variance = last[pixel];
        sum += variance;
        squares += variance * variance;
        count++;
      }
    }
    return count == 0
        ? 0
        : ErrorModel.CALIBRATION * Math.sqrt((sum + HARDLY * Math.sqrt(squares)) / count);
  }

  /** Returns the error that is claimed for a pixel, in levels: what it and its neighbours tell. */
  double error(int x, int y) {
    int width = image.width();
    double sum = 0;
    int count = 0;
    for (int row = Math.max(0, y - 1); row <= Math.min(image.height() - 1, y + 1); row++) {
      for (int column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column++) {
        sum += last[row * width + column];
        count++;
      }
    }
    return ErrorModel.CALIBRATION * Math.sqrt(sum / count);
  }

  /**
   * Returns how V falls, as all pixels together tell; as far as they are too few to tell, like at
   * edges.
   */
  private double fall() {
    if (samples < 4) {
      return FIRST_FALL;
    }
    double now = 0;
    double then = 0;
    double squares = 0;
    for (int pixel = 0; pixel < last.length; pixel++) {
      if (isWatched(pixel)) {
        now += last[pixel];
        then += before[pixel];
        squares += (double) last[pixel] * last[pixel];
      }
    }
    double doubt = Math.sqrt(squares);
    double ratio = (then + StrictMath.pow(2, FALL) * doubt) / (now + doubt);
    double fall = StrictMath.log(ratio) / StrictMath.log(2);
    return fall >= LEAST_FALL ? Math.min(fall, MOST_FALL) : LEAST_FALL; // NaN where nothing moves
  }

  /**
   * Returns V for all samples in relation to that for a power of two: they are a mean of blocks
   * that are powers of two, as if these knew nothing of each other.
   */
  private double left(double fall) {
    double power = Integer.highestOneBit(samples);
    double sum = 0;
    for (int rest = samples; rest > 0; rest -= Integer.highestOneBit(rest)) {
      double block = Integer.highestOneBit(rest);
      sum += block / samples * (block / samples) * StrictMath.pow(power / block, fall);
    }
    return sum;
  }

  /** Has second differences tell the variances. */
  private void bend() {
    int width = image.width();
    int height = image.height();
    for (int pixel = 0; pixel < last.length; pixel++) {
      if (!everywhere && !isWatched(pixel)) {
        continue;
      }
      int x = pixel % width;
      int y = pixel / width;
      double sum = 0;
      for (int channel = 0; channel < 3; channel++) {
        int at = 3 * pixel + channel;
        double across = x > 0 && x + 1 < width ? bend(at, 3) : 0;
        double down = y > 0 && y + 1 < height ? bend(at, 3 * width) : 0;
        sum += across * across + down * down;
      }
      last[pixel] = (float) (STEP * sum / 3);
    }
  }

  private double bend(int at, int step) {
    double[] rgb = image.rgb();
    return scale.level(rgb[at - step]) - 2 * scale.level(rgb[at]) + scale.level(rgb[at + step]);
  }
}
