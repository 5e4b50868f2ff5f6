package glint.render;

import glint.image.Image;
import java.util.Arrays;

/** Tells from second differences how far radiance bends within a pixel; scratch. */
final class Bends {

  /** A step counts as so many bends: 12/√12. */
  private static final double STEP = 2 * Math.sqrt(3);

  private final CornerGrid corners;
  private final LevelScale scale;
  private final double[] bends = new double[3];

  Bends(CornerGrid corners, LevelScale scale) {
    this.corners = corners;
    this.scale = scale;
  }

  /**
   * Returns the square, in levels², of the error of a mean that takes radiance to run evenly
   * between corners: of the trapezoidal rule, a twelfth of the second differences.
   *
   * @param image where the mean of the pixel stands
   */
  double error(int x, int y, Image image) {
    int a = y * corners.stride + x;
    Arrays.fill(bends, 0);
    bend(a, 1, x, corners.stride);
    bend(a + corners.stride, 1, x, corners.stride);
    bend(a, corners.stride, y, corners.rows);
    bend(a + 1, corners.stride, y, corners.rows);
    double sum = 0;
    for (int channel = 0; channel < 3; channel++) {
      if (bends[channel] > 0) {
        double mean = image.rgb()[3 * (y * image.width() + x) + channel];
        sum += scale.squaredError(mean, bends[channel] / 24);
      }
    }
    return sum / 3;
  }

  /**
   * Adds to {@link #bends} the second difference along a side that no edge crosses, without its
   * sign: the mean of those that its two neighbours give as far as they show the same signature;
   * where none does, the difference of its ends.
   *
   * <p>Where the two disagree there is a step rather than a bend, no one knows where along the
   * side: it is worth the standard deviation of a place even in a range, 1/√12, in twelfths.
   */
  private void bend(int corner, int step, int at, int count) {
    double[] rgb = corners.rgb;
    long[] met = corners.signature;
    if (met[corner] != met[corner + step]) {
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
        bends[channel] += 0.5 * (Math.abs(first + last) + STEP * Math.abs(first - last));
      } else {
        bends[channel] += before || after ? Math.abs(first + last) : Math.abs(two - one);
      }
    }
  }
}
