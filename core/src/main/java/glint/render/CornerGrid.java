package glint.render;

import glint.image.Image;

/**
 * One sample at every corner of every pixel, shared by the up to four pixels that meet there.
 *
 * <p>Corner (x, y) is the upper left one of pixel (x, y); there is one column and one row more of
 * corners than of pixels.
 */
final class CornerGrid {

  /** Corners in a row. */
  final int stride;

  final int rows;

  /** What each corner's ray met. */
  final long[] signature;

  /** What each corner sees, as in {@link glint.trace.Tracer#first}. */
  final int[] first;

  /** Linear radiance, three numbers a corner. */
  final double[] rgb;

  /** The same in levels. */
  final float[] levels;

  /** What images are seen; null if there are none. */
  final Prints prints;

  /** Whether the ray, or one that came of it, was a random one of many. */
  final boolean[] random;

  /** What casts shadows there, as in {@link glint.trace.Veil#casters}; empty if there are none. */
  private final long[] casters;

  /** By how much they darken what is there: the square, in levels². */
  private final float[] kept;

  /** A bound on the radiance left out. */
  final float[] cut;

  /** Whether there was no ray: what is there is told from the corners around. */
  final boolean[] filledIn;

  /**
   * Makes a grid for a picture.
   *
   * @param images whether there are images to be looked at
   * @param shadows whether anything throws shadows
   */
  CornerGrid(int width, int height, boolean images, boolean shadows) {
    stride = width + 1;
    rows = height + 1;
    signature = new long[stride * rows];
    first = new int[stride * rows];
    rgb = new double[3 * stride * rows];
    levels = new float[3 * stride * rows];
    random = new boolean[stride * rows];
    casters = new long[shadows ? stride * rows : 0];
    kept = new float[casters.length];
    cut = new float[stride * rows];
    filledIn = new boolean[stride * rows];
    prints = images ? new Prints(stride * rows) : null;
  }

  /** Traces a corner; one that is not finite is black and unlike any other. */
  void trace(Probe probe, LevelScale scale, int x, int y) {
    int at = y * stride + x;
    boolean shadows = casters.length > 0;
    boolean finite = shadows ? probe.traceWatching(x, y) : probe.trace(x, y);
    signature[at] = finite ? probe.signature() : at;
    first[at] = probe.first();
    random[at] = probe.isRandom();
    if (shadows) {
      casters[at] = probe.casters();
      kept[at] = finite && casters[at] != 0 ? (float) probe.kept(scale) : 0;
    }
    rgb[3 * at] = finite ? probe.r() : 0;
    rgb[3 * at + 1] = finite ? probe.g() : 0;
    rgb[3 * at + 2] = finite ? probe.b() : 0;
    for (int i = 3 * at; i < 3 * at + 3; i++) {
      levels[i] = (float) scale.level(rgb[i]);
    }
    cut[at] = finite ? (float) probe.cut() : 0;
    if (prints != null) {
      prints.note(at, probe, scale, levels);
    }
  }

  /** Returns whether the eight corners so far around one met the same in the same shadows. */
  boolean isAlike(int at, int step) {
    for (int row = at - step * stride; row <= at + step * stride; row += step * stride) {
      for (int other = row - step; other <= row + step; other += step) {
        boolean alike = signature[other] == signature[at];
        if (!alike || (casters.length > 0 && casters[other] != casters[at])) {
          return false;
        }
      }
    }
    return true;
  }

  /** Returns whether second differences between corners so far apart are at most so many levels. */
  boolean isEven(int at, int step, float most) {
    for (int i = 3 * at; i < 3 * at + 3; i++) {
      float twice = 2 * levels[i];
      int down = 3 * step * stride;
      if (!(Math.abs(levels[i - 3 * step] - twice + levels[i + 3 * step]) <= most
          && Math.abs(levels[i - down] - twice + levels[i + down]) <= most)) {
        return false;
      }
    }
    return true;
  }

  /** Fills a corner in by a cubic through four on a line with it, of which two are next to it. */
  void fill(int at, int step) {
    int a = at - step;
    signature[at] = signature[a];
    first[at] = first[a];
    random[at] = false;
    if (casters.length > 0) {
      casters[at] = casters[a];
      kept[at] = Math.max(kept[a], kept[at + step]);
    }
    cut[at] = 0;
    filledIn[at] = true;
    for (int i = 3 * at; i < 3 * at + 3; i++) {
      double near = rgb[i - 3 * step] + rgb[i + 3 * step];
      double far = rgb[i - 9 * step] + rgb[i + 9 * step];
      rgb[i] = Math.max(0, (9 * near - far) / 16);
      levels[i] = 0.5f * (levels[i - 3 * step] + levels[i + 3 * step]);
    }
    if (prints != null) {
      prints.fill(at, levels);
    }
  }

  /** Shows a corner in a pixel of a picture. */
  void show(int x, int y, Image picture, int column, int row) {
    int at = 3 * (y * stride + x);
    picture.set(column, row, rgb[at], rgb[at + 1], rgb[at + 2]);
  }

  /**
   * Returns whether a pixel has sides whose ends meet the same, but in an image with so much of
   * that between them that they tell little of what lies there.
   */
  boolean leapsOverDetail(int x, int y) {
    int a = y * stride + x;
    int c = a + stride;
    return prints != null
        && (leaps(a, a + 1) || leaps(c, c + 1) || leaps(a, c) || leaps(a + 1, c + 1));
  }

  private boolean leaps(int a, int b) {
    return signature[a] == signature[b] && (prints.leaps(a, b) || prints.leapsBeyond(a, b));
  }

  /**
   * Returns the same of a pixel all of whose corners meet the same, but for what they meet first.
   */
  boolean leapsBeyond(int x, int y) {
    int a = y * stride + x;
    int c = a + stride;
    return prints.leapsBeyond(a, a + 1)
        || prints.leapsBeyond(c, c + 1)
        || prints.leapsBeyond(a, c)
        || prints.leapsBeyond(a + 1, c + 1);
  }

  /**
   * Returns which sides of a pixel have ends that meet different things, as edges make them: bit 0
   * for the top, 1 bottom, 2 left, 3 right.
   */
  int crossed(int x, int y) {
    int a = y * stride + x;
    int c = a + stride;
    int crossed = signature[a] != signature[a + 1] ? 1 : 0;
    crossed |= signature[c] != signature[c + 1] ? 2 : 0;
    crossed |= signature[a] != signature[c] ? 4 : 0;
    return crossed | (signature[a + 1] != signature[c + 1] ? 8 : 0);
  }

  /** Returns the mean radiance at the corners of a pixel, in one channel. */
  double mean(int x, int y, int channel) {
    int a = 3 * (y * stride + x) + channel;
    int c = a + 3 * stride;
    return 0.25 * (rgb[a] + rgb[a + 3] + rgb[c] + rgb[c + 3]);
  }

  /** Returns how many sides of a pixel have ends that meet something different. */
  int crossings(int x, int y) {
    return Integer.bitCount(crossed(x, y));
  }

  /**
   * Returns how much light may fall between the shadows of several things at the corners of a
   * pixel: the square of a difference, in levels²; 0 where all corners are in the same shadows.
   */
  float lightBetweenShadows(int x, int y) {
    if (casters.length == 0) {
      return 0;
    }
    int a = y * stride + x;
    int c = a + stride;
    long here = casters[a];
    boolean same = casters[a + 1] == here && casters[c] == here && casters[c + 1] == here;
    return same ? 0 : Math.max(Math.max(kept[a], kept[a + 1]), Math.max(kept[c], kept[c + 1]));
  }

  /** Returns whether one ray does not tell all at a corner of a pixel. */
  boolean isRandom(int x, int y) {
    int a = y * stride + x;
    int c = a + stride;
    return random[a] || random[a + 1] || random[c] || random[c + 1];
  }

  /**
   * Finds, for a row of pixels, the variance, in levels² and the mean over channels, of the up to
   * 16 corners of each pixel and its neighbours.
   *
   * @param levels of the corners: {@link #levels}, or {@link Prints#plain}
   * @param scratch six numbers for every column of corners
   * @param out where the variances are stored, from an index on
   */
  void contrasts(int y, float[] levels, double[] scratch, float[] out, int index) {
    int channels = 3 * stride;
    int first = Math.max(0, y - 1);
    int last = Math.min(rows - 1, y + 2);
    for (int i = 0; i < channels; i++) {
      double sum = 0;
      double squares = 0;
      for (int at = first * channels + i; at <= last * channels + i; at += channels) {
        double level = levels[at];
        sum += level;
        squares += level * level;
      }
      scratch[2 * i] = sum;
      scratch[2 * i + 1] = squares;
    }
    for (int x = 0; x < stride - 1; x++) {
      int left = Math.max(0, x - 1);
      int right = Math.min(stride - 1, x + 2);
      int count = (right - left + 1) * (last - first + 1);
      double r = 0;
      double g = 0;
      double b = 0;
      double r2 = 0;
      double g2 = 0;
      double b2 = 0;
      for (int i = 6 * left; i <= 6 * right; i += 6) {
        r += scratch[i];
        r2 += scratch[i + 1];
        g += scratch[i + 2];
        g2 += scratch[i + 3];
        b += scratch[i + 4];
        b2 += scratch[i + 5];
      }
      double variance = variance(r, r2, count) + variance(g, g2, count) + variance(b, b2, count);
      out[index + x] = (float) (variance / 3);
    }
  }

  private static double variance(double sum, double squares, int count) {
    double mean = over(sum, count);
    double variance = over(squares, count) - mean * mean;
    return variance > 0 ? variance : 0;
  }

  /** Divides by a count of corners; by most without a division, which comes to the same. */
  private static double over(double sum, int count) {
    return count == 16 ? sum * 0x1p-4 : sum / count;
  }
}
