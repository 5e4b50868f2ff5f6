package glint.render;

import glint.image.Image;

/** Tells from second differences how far radiance bends within a pixel; scratch. */
final class Bends {

  /** A step counts as so many bends: 12/√12. */
  private static final double STEP = 2 * Math.sqrt(3);

  private static final double TWENTY_FOURTH = 1 / 24.0;
  private static final double THIRD = 1 / 3.0;

  private final CornerGrid corners;
  private final LevelScale scale;

  /** Numbers of a row of corners. */
  private final int channels;

  /** The bends of the sides of a pixel, or of a row of them: above, below, left and right. */
  private final double[] pixel = new double[12];

  private double[] above;
  private double[] below;
  private final double[] down;

  /** The row of pixels that those are of, or -1. */
  private int row = -1;

  /** The second differences at a row of corners, from column to column. */
  private final double[] across;

  /** Those from row to row, at the corners above and below. */
  private double[] downAbove;

  private double[] downBelow;

  Bends(CornerGrid corners, LevelScale scale) {
    this.corners = corners;
    this.scale = scale;
    channels = 3 * corners.stride;
    above = new double[channels];
    below = new double[channels];
    down = new double[channels];
    across = new double[channels];
    downAbove = new double[channels];
    downBelow = new double[channels];
  }

  /**
   * Returns the square, in levels², of the error of a mean that takes radiance to run evenly
   * between corners: of the trapezoidal rule, a twelfth of the second differences.
   *
   * @param image where the mean of the pixel stands
   */
  double error(int x, int y, Image image) {
    if (y == row) {
      return errorInRow(x, image);
    }
    int a = y * corners.stride + x;
    bend(a, 1, x, corners.stride, pixel, 0);
    bend(a + corners.stride, 1, x, corners.stride, pixel, 3);
    bend(a, corners.stride, y, corners.rows, pixel, 6);
    bend(a + 1, corners.stride, y, corners.rows, pixel, 9);
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      double bend = pixel[i] + pixel[i + 3] + pixel[i + 6] + pixel[i + 9];
      sum += squaredError(bend, x, y, i, image);
    }
    return THIRD * sum;
  }

  /** Turns to a row of pixels, whose errors are found faster from then on. */
  void turn(int y) {
    if (y == row + 1 && row >= 0) {
      double[] known = above;
      above = below;
      below = known;
      known = downAbove;
      downAbove = downBelow;
      downBelow = known;
    } else {
      across(y, above);
      differ(y, corners.stride, downAbove);
    }
    across(y + 1, below);
    differ(y + 1, corners.stride, downBelow);
    bend(downAbove, downBelow, 0, down);
    for (int x = 0; x < corners.stride; x++) {
      correct(y * corners.stride + x, corners.stride, y, corners.rows, down, 3 * x);
    }
    row = y;
  }

  private void across(int y, double[] out) {
    differ(y, 1, across);
    bend(across, across, 3, out);
    for (int x = 0; x < corners.stride - 1; x++) {
      correct(y * corners.stride + x, 1, x, corners.stride, out, 3 * x);
    }
  }

  private double errorInRow(int x, Image image) {
    double sum = 0;
    for (int i = 3 * x; i < 3 * x + 3; i++) {
      double bend = above[i] + below[i] + down[i] + down[i + 3];
      sum += squaredError(bend, x, row, i - 3 * x, image);
    }
    return THIRD * sum;
  }

  private double squaredError(double bend, int x, int y, int channel, Image image) {
    if (!(bend > 0)) {
      return 0;
    }
    double mean = image.rgb()[3 * (y * image.width() + x) + channel];
    return scale.squaredError(mean, TWENTY_FOURTH * bend);
  }

  /** Finds the second differences at a row of corners that have others on both sides. */
  private void differ(int y, int step, double[] out) {
    double[] rgb = corners.rgb;
    int from = y * channels;
    int begin = Math.max(0, 3 * step - from);
    int end = Math.min(channels, rgb.length - 3 * step - from);
    for (int i = begin; i < end; i++) {
      int at = from + i;
      out[i] = rgb[at - 3 * step] - 2 * rgb[at] + rgb[at + 3 * step];
    }
  }

  /** Finds the bends of sides whose ends, and the corners beyond, all show the same signature. */
  private static void bend(double[] one, double[] two, int next, double[] out) {
    for (int i = 0; i < out.length - next; i++) {
      double first = one[i];
      double last = two[i + next];
      out[i] = 0.5 * (Math.abs(first + last) + STEP * Math.abs(first - last));
    }
  }

  /** Finds the bend of a side anew if it is not as simple as that. */
  private void correct(int corner, int step, int at, int count, double[] out, int index) {
    long[] met = corners.signature;
    boolean simple =
        at > 0
            && at + 2 < count
            && met[corner - step] == met[corner]
            && met[corner + step] == met[corner]
            && met[corner + 2 * step] == met[corner];
    if (!simple) {
      bend(corner, step, at, count, out, index);
    }
  }

  /**
   * Finds the second difference along a side that no edge crosses, without its sign: the mean of
   * those that its two neighbours give as far as they show the same signature; where none does, the
   * difference of its ends.
   *
   * <p>Where the two disagree there is a step rather than a bend, no one knows where along the
   * side: it is worth the standard deviation of a place even in a range, 1/√12, in twelfths.
   *
   * @param out where its channels are stored, three numbers from an index on
   */
  private void bend(int corner, int step, int at, int count, double[] out, int index) {
    double[] rgb = corners.rgb;
    long[] met = corners.signature;
    if (met[corner] != met[corner + step]) {
      out[index] = 0;
      out[index + 1] = 0;
      out[index + 2] = 0;
      return;
    }
    boolean before = at > 0 && met[corner - step] == met[corner];
    boolean after = at + 2 < count && met[corner + 2 * step] == met[corner];
    for (int channel = 0; channel < 3; channel++) {
      int i = 3 * corner + channel;
      double one = rgb[i];
      double two = rgb[i + 3 * step];
      double first = before ? rgb[i - 3 * step] - 2 * one + two : 0;
      double last = after ? one - 2 * two + rgb[i + 6 * step] : 0;
      if (before && after) {
        out[index + channel] = 0.5 * (Math.abs(first + last) + STEP * Math.abs(first - last));
      } else {
        out[index + channel] = before || after ? Math.abs(first + last) : Math.abs(two - one);
      }
    }
  }
}
