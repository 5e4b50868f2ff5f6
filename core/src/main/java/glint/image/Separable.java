package glint.image;

import java.util.Arrays;

/**
 * Filtering of a plane of values with the product of a row and a column kernel.
 *
 * <p>Beyond the border the outermost value is repeated. A kernel has odd length; its middle weighs
 * the pixel itself, its first element the pixel to the left of or above all others.
 */
final class Separable {

  private Separable() {}

  /** Returns the plane filtered with the kernel {@code alongX} and then with {@code alongY}. */
  static double[] filter(double[] plane, int width, int height, double[] alongX, double[] alongY) {
    return alongColumns(alongRows(plane, width, height, alongX), width, height, alongY);
  }

  /** Returns the Gaussian {@code exp(-rate * k²)}, k = -radius … radius, scaled to the sum 1. */
  static double[] gaussian(int radius, double rate) {
    double[] kernel = new double[2 * radius + 1];
    double sum = 0;
    for (int i = 0; i < kernel.length; i++) {
      double k = i - radius;
      kernel[i] = StrictMath.exp(-rate * k * k);
      sum += kernel[i];
    }
    for (int i = 0; i < kernel.length; i++) {
      kernel[i] /= sum;
    }
    return kernel;
  }

  private static double[] alongRows(double[] plane, int width, int height, double[] kernel) {
    int radius = kernel.length / 2;
    double[] padded = new double[width + 2 * radius];
    double[] filtered = new double[plane.length];
    for (int y = 0; y < height; y++) {
      // Repeat the outermost values beyond both ends of the row
      int row = y * width;
      Arrays.fill(padded, 0, radius, plane[row]);
      System.arraycopy(plane, row, padded, radius, width);
      Arrays.fill(padded, radius + width, padded.length, plane[row + width - 1]);
      for (int k = 0; k < kernel.length; k++) {
        addScaled(kernel[k], padded, k, filtered, row, width);
      }
    }
    return filtered;
  }

  private static double[] alongColumns(double[] plane, int width, int height, double[] kernel) {
    int radius = kernel.length / 2;
    double[] filtered = new double[plane.length];
    for (int y = 0; y < height; y++) {
      for (int k = 0; k < kernel.length; k++) {
        int source = Math.min(Math.max(y + k - radius, 0), height - 1);
        addScaled(kernel[k], plane, source * width, filtered, y * width, width);
      }
    }
    return filtered;
  }

  /** Adds a multiple of one run of values to another: the loop that takes all the time. */
  private static void addScaled(
      double factor, double[] from, int fromAt, double[] to, int toAt, int count) {
    for (int i = 0; i < count; i++) {
      to[toAt + i] += factor * from[fromAt + i];
    }
  }
}
