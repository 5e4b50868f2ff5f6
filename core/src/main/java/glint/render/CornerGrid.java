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

  /** Returns whether two corners met the same in the same shadows. */
  boolean areAlike(int one, int two) {
    return signature[one] == signature[two]
        && (casters.length == 0 || casters[one] == casters[two]);
  }

  /**
   * Returns whether levels bend little enough along a line to fill a corner in: second differences
   * between corners one and three steps away are at most so many levels, or what they change by is.
   *
   * @param before whether the line goes on alike three steps before the corner
   * @param after whether it does so three steps after it
   * @param curve how many levels they are at most even then
   */
  boolean isEven(int at, int step, boolean before, boolean after, float most, float curve) {
    float bend = 0;
    float change = 0;
    int next = 3 * step;
    for (int i = 3 * at; i < 3 * at + 3; i++) {
      float rise = levels[i + next] - levels[i - next];
      float first = before ? rise - (levels[i - next] - levels[i - 3 * next]) : 0;
      float last = after ? levels[i + 3 * next] - levels[i + next] - rise : 0;
      bend = Math.max(bend, Math.max(Math.abs(first), Math.abs(last)));
      change = Math.max(change, Math.abs(last - first));
    }
    return bend <= most || (before && after && bend <= curve && change <= most);
  }

  /**
   * Fills a corner in from those on a line with it, on both sides of it one and two steps away: by
   * a cubic through four, or a parabola through three.
   *
   * @param before whether the line goes on alike before those next to it
   * @param after whether it does so after them; one of both is true
   */
  void fill(int at, int step, boolean before, boolean after) {
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
    int next = 3 * step;
    for (int i = 3 * at; i < 3 * at + 3; i++) {
      double sum = rgb[i - next] + rgb[i + next];
      double middle;
      if (before && after) {
        middle = (9 * sum - (rgb[i - 3 * next] + rgb[i + 3 * next])) * 0x1p-4;
      } else {
        int on = after ? next : -next;
        middle = (3 * (sum + rgb[i + on]) - rgb[i + 3 * on]) * 0x1p-3;
      }
      rgb[i] = Math.max(0, middle);
      levels[i] = 0.5f * (levels[i - next] + levels[i + next]);
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
}
