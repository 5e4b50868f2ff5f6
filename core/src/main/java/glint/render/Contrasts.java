package glint.render;

/**
 * Finds how much the corners of pixels and of their neighbours differ; scratch.
 *
 * <p>Rows are best asked for one after another: what is known of three in four rows of corners then
 * is known already. Its loops are such as a compiler makes one of vectors.
 */
final class Contrasts {

  /** Rows of corners around a row of pixels, but at the ends of the image. */
  private static final int ROWS = 4;

  private final CornerGrid corners;
  private final float[] levels;

  /** The numbers of a row of corners. */
  private final int channels;

  /**
   * Levels, and their squares, of the last rows that were turned to, by row modulo {@link #ROWS}.
   */
  private final double[][] level;

  private final double[][] square;

  /** Which rows those are, or -1. */
  private final int[] known = {-1, -1, -1, -1};

  /** Sums over the rows. */
  private final double[] sums;

  private final double[] squares;

  private final double[] variances;

  /**
   * Makes contrasts of a grid.
   *
   * @param levels of the corners: {@link CornerGrid#levels}, or {@link Prints#plain}
   */
  Contrasts(CornerGrid corners, float[] levels) {
    this.corners = corners;
    this.levels = levels;
    channels = 3 * corners.stride;
    level = new double[ROWS][channels];
    square = new double[ROWS][channels];
    sums = new double[channels];
    squares = new double[channels];
    variances = new double[channels];
  }

  /**
   * Finds, for a row of pixels, the variance, in levels² and the mean over channels, of the up to
   * 16 corners of each pixel and its neighbours.
   *
   * @param out where the variances are stored, from an index on
   */
  void find(int y, float[] out, int index) {
    int first = Math.max(0, y - 1);
    int last = Math.min(corners.rows - 1, y + 2);
    for (int row = first; row <= last; row++) {
      turn(row);
    }
    int count = last - first + 1;
    add(level, first, count, sums);
    add(square, first, count, squares);
    inside(sums, squares, 0.25 / count, variances);
    int end = corners.stride - 2;
    for (int x = 0; x <= end; x += x == 0 ? Math.max(1, end) : 1) {
      atEnd(x, count);
    }
    for (int x = 0; x <= end; x++) {
      int i = 3 * x;
      out[index + x] = (float) ((variances[i] + variances[i + 1] + variances[i + 2]) / 3);
    }
  }

  private void turn(int row) {
    int at = row % ROWS;
    if (known[at] == row) {
      return;
    }
    known[at] = row;
    double[] one = level[at];
    double[] two = square[at];
    int from = row * channels;
    for (int i = 0; i < channels; i++) {
      double value = levels[from + i];
      one[i] = value;
      two[i] = value * value;
    }
  }

  private static void add(double[][] rows, int first, int count, double[] out) {
    double[] a = rows[first % ROWS];
    double[] b = rows[(first + 1) % ROWS];
    double[] c = rows[(first + 2) % ROWS];
    double[] d = rows[(first + 3) % ROWS];
    if (count == ROWS) {
      for (int i = 0; i < out.length; i++) {
        out[i] = a[i] + b[i] + c[i] + d[i];
      }
    } else {
      for (int i = 0; i < out.length; i++) {
        out[i] = a[i] + b[i] + (count > 2 ? c[i] : 0);
      }
    }
  }

  /** Finds the variances, by channel, of pixels that have neighbours on both sides. */
  private static void inside(double[] sums, double[] squares, double share, double[] out) {
    for (int i = 3; i < out.length - 6; i++) {
      double mean = share * (sums[i - 3] + sums[i] + sums[i + 3] + sums[i + 6]);
      double all = share * (squares[i - 3] + squares[i] + squares[i + 3] + squares[i + 6]);
      out[i] = Math.max(0, all - mean * mean);
    }
  }

  private void atEnd(int x, int rows) {
    int left = 3 * Math.max(0, x - 1);
    int right = 3 * Math.min(corners.stride - 1, x + 2);
    for (int channel = 0; channel < 3; channel++) {
      double sum = 0;
      double all = 0;
      for (int i = left + channel; i <= right + channel; i += 3) {
        sum += sums[i];
        all += squares[i];
      }
      int count = ((right - left) / 3 + 1) * rows;
      double mean = sum / count;
      variances[3 * x + channel] = Math.max(0, all / count - mean * mean);
    }
  }
}
