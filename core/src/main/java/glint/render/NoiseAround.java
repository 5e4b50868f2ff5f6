package glint.render;

/** Estimates what as much noise as there is around a pixel of random samples would be in it. */
final class NoiseAround {

  private final Film film;
  private final CornerGrid corners;
  private final LevelScale scale;

  NoiseAround(Film film, CornerGrid corners, LevelScale scale) {
    this.film = film;
    this.corners = corners;
    this.scale = scale;
  }

  /** Notes in the film what there is around a sampled pixel. */
  void listen(int x, int y) {
    int pixel = y * film.width + x;
    int n = film.samples(pixel);
    double sum = 0;
    for (int channel = 0; channel < 3; channel++) {
      double mean = film.image.rgb()[3 * pixel + channel];
      double spread = Math.sqrt(variance(x, y, channel) / n);
      sum += n * scale.squaredError(mean, spread);
    }
    film.noise[pixel] = (float) Math.max(sum / 3, (double) n * n * glare(x, y, n));
  }

  /** Returns the mean variance, linear, of single samples of the sampled pixels around one. */
  private double variance(int x, int y, int channel) {
    double sum = 0;
    int count = 0;
    for (int row = Math.max(0, y - 1); row <= Math.min(film.height - 1, y + 1); row++) {
      int end = Math.min(film.width - 1, x + 1);
      for (int column = Math.max(0, x - 1); column <= end; column++) {
        int other = row * film.width + column;
        boolean here = row == y && column == x;
        if (!here && film.level[other] > 0 && !film.focus.containsKey(other)) {
          int at = Film.SLOT * film.slot[other] + channel;
          int n = Math.max(2, film.valid[film.slot[other]]);
          double once = film.sums[at];
          sum += Math.max(0, film.sums[at + 3] - once * once / n) / (n - 1);
          count++;
        }
      }
    }
    return count == 0 ? 0 : sum / count;
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
