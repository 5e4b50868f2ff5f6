package glint.render;

import glint.image.Image;
import java.util.Arrays;
import java.util.function.IntConsumer;

/** What is known of every pixel while an image is refined: flat arrays in row order. */
final class Film {

  /** The four corners show one signature: taken for smooth, from corner to corner. */
  static final byte SMOOTH = 0;

  /** One edge divides the pixel in two. */
  static final byte SPLIT = 1;

  /** Anything else: nothing is taken for known. */
  static final byte BUSY = 2;

  /**
   * Doubles of a sampled pixel, by channel: sum, sum of squares, mean of the model and variance of
   * a single sample.
   */
  static final int SLOT = 12;

  /** A variance of what samples find, in levels², that is much. */
  private static final double FOUND = 4;

  /** Samples anywhere in a pixel do well enough for a part of it that is larger. */
  private static final double LARGE = 0.9;

  final int width;
  final int height;

  /** The pixels' means. */
  final Image image;

  final byte[] kind;

  /** How much is going on around: 0 nothing, up to 15. */
  final byte[] surroundings;

  /** Whether the corners of a smooth pixel are in the shadows of several things. */
  final boolean[] veiled;

  /** Whether a smooth pixel is found from the image that it shows. */
  final boolean[] inlaid;

  /** Whether corners do not tell all that is to be seen, because their rays are random ones. */
  final boolean[] random;

  /** Whether the pixel was looked at amid its corners. */
  final boolean[] checked;

  /** Whether what was seen there is of a kind with the upper left corner. */
  final boolean[] insideAsCorner;

  /** The logarithm to base 2 of the number of samples; 0 for none. */
  final byte[] level;

  /** Of an unsampled pixel a variance in levels², else what its samples say of theirs. */
  final float[] own;

  /** The part of that, of a split pixel, that no better knowledge of its sides takes away. */
  final float[] doubt;

  /** The variance of the surroundings, in levels². */
  final float[] contrast;

  /** The parts of busy pixels that are sampled by themselves, or null. */
  final Focus[] focus;

  /** What single samples around find, or bright corners show: as much would here be, in levels². */
  final float[] noise;

  /** Whether more is known of the edges of a pixel, or of those around, since its estimate. */
  final boolean[] stale;

  /** Where the sums of a sampled pixel stand, or -1. */
  final int[] slot;

  /** Numbers of an edge. */
  static final int EDGE = 3;

  /**
   * Where the edge of a split pixel was when it was first sampled, by slot: along the two sides,
   * and its bulge.
   */
  float[] edge = new float[EDGE * 64];

  /** Sums of what samples differ from the pixel's model by, see {@link #SLOT}. */
  double[] sums = new double[64 * SLOT];

  /** A bound on what samples left out, summed, by slot. */
  float[] cut = new float[64];

  /** The variance of the pixel's model when it was first sampled, in levels², by slot. */
  float[] prior = new float[64];

  /** How many of the samples were finite, by slot. */
  int[] valid = new int[64];

  private int slots;

  /** Makes a film of unknown pixels. */
  Film(Image image) {
    this.image = image;
    width = image.width();
    height = image.height();
    int count = width * height;
    kind = new byte[count];
    surroundings = new byte[count];
    veiled = new boolean[count];
    inlaid = new boolean[count];
    random = new boolean[count];
    checked = new boolean[count];
    insideAsCorner = new boolean[count];
    level = new byte[count];
    own = new float[count];
    doubt = new float[count];
    contrast = new float[count];
    noise = new float[count];
    stale = new boolean[count];
    focus = new Focus[count];
    slot = new int[count];
    Arrays.fill(slot, -1);
  }

  /** Gives pixels that are about to be sampled places for their sums, if they have none. */
  void open(int[] pixels) {
    int first = slots;
    for (int pixel : pixels) {
      slot[pixel] = slot[pixel] < 0 ? slots++ : slot[pixel];
    }
    if (slots > cut.length) {
      int more = Math.max(slots, first + (first >> 1));
      edge = Arrays.copyOf(edge, EDGE * more);
      sums = Arrays.copyOf(sums, more * SLOT);
      cut = Arrays.copyOf(cut, more);
      prior = Arrays.copyOf(prior, more);
      valid = Arrays.copyOf(valid, more);
    }
  }

  /**
   * Notes that more is known of an edge in a pixel: what the four beside it make of theirs, too.
   */
  void outdate(int x, int y) {
    if (x < 0 || y < 0 || x >= width || y >= height) {
      return;
    }
    int pixel = y * width + x;
    stale[pixel] = true;
    stale[x > 0 ? pixel - 1 : pixel] = true;
    stale[x < width - 1 ? pixel + 1 : pixel] = true;
    stale[y > 0 ? pixel - width : pixel] = true;
    stale[y < height - 1 ? pixel + width : pixel] = true;
  }

  /** Notes that more is known of a pixel: of what is around those of random samples beside it. */
  void outdateAround(int pixel) {
    int x = pixel % width;
    int y = pixel / width;
    for (int row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row++) {
      for (int column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column++) {
        stale[row * width + column] |= random[row * width + column];
      }
    }
  }

  /** Forgets the samples of a pixel. */
  void forget(int pixel) {
    level[pixel] = 0;
    stale[pixel] = true;
    valid[slot[pixel]] = 0;
    cut[slot[pixel]] = 0;
    Arrays.fill(sums, SLOT * slot[pixel], SLOT * (slot[pixel] + 1), 0);
  }

  /** Notes that a pixel shows something small, in a part that is sampled by itself if it is. */
  void aim(int pixel, Focus seen) {
    kind[pixel] = BUSY;
    if (seen.area() > LARGE) {
      contrast[pixel] = Math.max(contrast[pixel], (float) seen.unseen());
    } else {
      contrast[pixel] = random[pixel] ? contrast[pixel] : 0;
      focus[pixel] = seen;
    }
  }

  /** Returns the number of samples of a pixel. */
  int samples(int pixel) {
    return level[pixel] == 0 ? 0 : 1 << level[pixel];
  }

  /**
   * Takes the contrast around a busy pixel to be at least what the samples of its busy neighbours
   * have found: those of its own may be all alike by chance.
   */
  void compare(int pixel) {
    if (kind[pixel] != BUSY || (focus[pixel] != null && !random[pixel])) {
      return;
    }
    int x = pixel % width;
    int y = pixel / width;
    double sum = 0;
    int count = 0;
    for (int row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row++) {
      for (int column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column++) {
        int other = row * width + column;
        if (kind[other] == BUSY && level[other] > 0 && other != pixel) {
          sum += samples(other) * own[other];
          count++;
        }
      }
    }
    contrast[pixel] =
        count == 0 ? contrast[pixel] : Math.max(contrast[pixel], (float) (sum / count));
  }

  /** Returns whether samples of a pixel differ much from what its model says. */
  boolean foundMore(int pixel) {
    return level[pixel] > 0 && samples(pixel) * own[pixel] > FOUND;
  }

  /** Hands on the unsampled smooth pixels around one; returns whether there are any. */
  boolean forEachUnsampledAround(int pixel, IntConsumer work) {
    int x = pixel % width;
    int y = pixel / width;
    boolean any = false;
    for (int row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row++) {
      for (int column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column++) {
        int other = row * width + column;
        if (kind[other] == SMOOTH && level[other] == 0) {
          work.accept(other);
          any = true;
        }
      }
    }
    return any;
  }
}
