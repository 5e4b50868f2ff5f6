package glint.render;

import java.util.Arrays;

/** Estimates what as much noise as there is around a pixel of random samples would be in it. */
final class NoiseAround {

  private final Film film;
  private final CornerGrid corners;
  private final LevelScale scale;

  /** By channel, of single samples around. */
  private final double[] variance = new double[3];

  NoiseAround(Film film, CornerGrid corners, LevelScale scale) {
    this.film = film;
    this.corners = corners;
    this.scale = scale;
  }

  /** Notes in the film what there is around a sampled pixel. */
  void listen(int x, int y) {
    int pixel = y * film.width + x;
    int n = film.samples(pixel);
    findVariance(x, y);
    double sum = 0;
    for (int channel = 0; channel < 3; channel++) {
      double mean = film.image.rgb()[3 * pixel + channel];
      sum += n * scale.squaredError(mean, Math.sqrt(variance[channel] / n));
    }
    film.noise[pixel] = (float) Math.max(sum / 3, (double) n * n * glare(x, y, n));
  }

  /** Finds the mean variance, linear, of single samples of the sampled pixels around one. */
  private void findVariance(int x, int y) {
    Arrays.fill(variance, 0);
    int count = 0;
    for (int row = Math.max(0, y - 1); row <= Math.min(film.height - 1, y + 1); row++) {
      int end = Math.min(film.width - 1, x + 1);
      for (int column = Math.max(0, x - 1); column <= end; column++) {
        int other = row * film.width + column;
        boolean here = row == y && column == x;
        if (!here && film.level[other] > 0 && film.focus[other] == null) {
          int at = Film.SLOT * film.slot[other] + 9;
          variance[0] += film.sums[at];
          variance[1] += film.sums[at + 1];
          variance[2] += film.sums[at + 2];
          count++;
        }
      }
    }
    for (int channel = 0; count > 0 && channel < 3; channel++) {
      variance[channel] /= count;
    }
  }

  /**
   * Returns by how much, on average and squared, in levels², the mean of n samples would change if
   * a corner that is brighter than white were one more of them.
   */
  private double glare(int x, int y, int n) {
    double sum = 0;
    for (int i = 0; i < 4; i++) {
      int at = 3 * ((y + (i >> 1)) * corners.stride + x + (i & 1));
      for (int channel = 0; channel < 3; channel++) {
        double bright = corners.rgb[at + channel];
        if (bright > 1) {
          double now = film.image.rgb()[3 * (y * film.width + x) + channel];
          sum += scale.squaredDifference(now + (bright - now) / (n + 1), now);
        }
      }
    }
    return sum / 12;
  }
}
