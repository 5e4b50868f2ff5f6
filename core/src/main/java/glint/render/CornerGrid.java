package glint.render;

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

  /** Linear radiance, three numbers a corner. */
  final double[] rgb;

  /** A bound on the radiance left out. */
  final float[] cut;

  /** Makes a grid for an image. */
  CornerGrid(int width, int height) {
    stride = width + 1;
    rows = height + 1;
    signature = new long[stride * rows];
    rgb = new double[3 * stride * rows];
    cut = new float[stride * rows];
  }

  /** Traces a corner; one that is not finite is black and unlike any other. */
  void trace(Probe probe, int x, int y) {
    int at = y * stride + x;
    boolean finite = probe.trace(x, y);
    signature[at] = finite ? probe.signature() : at;
    rgb[3 * at] = finite ? probe.r() : 0;
    rgb[3 * at + 1] = finite ? probe.g() : 0;
    rgb[3 * at + 2] = finite ? probe.b() : 0;
    cut[at] = finite ? (float) probe.cut() : 0;
  }

  /**
   * Returns the variance, in levels² and the mean over channels, of the up to 16 corners of a pixel
   * and its neighbours.
   */
  double contrast(int x, int y, LevelScale scale) {
    double variance = 0;
    for (int channel = 0; channel < 3; channel++) {
      double sum = 0;
      double squares = 0;
      int count = 0;
      for (int row = Math.max(0, y - 1); row <= Math.min(rows - 1, y + 2); row++) {
        for (int column = Math.max(0, x - 1); column <= Math.min(stride - 1, x + 2); column++) {
          double level = scale.level(rgb[3 * (row * stride + column) + channel]);
          sum += level;
          squares += level * level;
          count++;
        }
      }
      variance += Math.max(0, squares / count - sum / count * (sum / count));
    }
    return variance / 3;
  }
}
