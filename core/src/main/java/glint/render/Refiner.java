package glint.render;

/**
 * Works on pixels of a film, one at a time; one per thread.
 *
 * <p>Samples are taken of what the model of a pixel gets wrong, which is that of its {@link
 * Estimator}, so that a good model leaves them little to find (a control variate).
 */
final class Refiner {

  /** The first samples of a pixel, as a power of two. */
  static final byte FIRST = 2;

  /** How much finer an image is looked at where samples are compared with it. */
  private static final int FINER = 2;

  private final Film film;
  private final CornerGrid corners;
  private final LevelScale scale;
  private final Split split;
  private final Inlay inlay;
  private final double[] model = new double[3];
  private final double[] before = new double[3];
  private final double[] mean = new double[3];

  final Probe probe;
  final Survey survey;
  final Aim aim;
  final Estimator estimator;

  Refiner(
      Film film,
      CornerGrid corners,
      Brackets brackets,
      LevelScale scale,
      Probe probe,
      double levels) {
    this.film = film;
    this.corners = corners;
    this.scale = scale;
    this.probe = probe;
    split = new Split(corners, brackets);
    inlay = new Inlay(corners, scale, probe.scene(), levels);
    survey = new Survey(film, corners, brackets, inlay, probe);
    aim = new Aim(corners, scale, probe);
    estimator = new Estimator(film, corners, brackets, inlay, scale);
  }

  /**
   * Takes samples of a pixel until there are 2^level of them.
   *
   * @return by how much the last doubling moved the mean: the square, in levels²
   */
  double sample(int x, int y, int level) {
    int pixel = y * film.width + x;
    int slot = film.slot[pixel];
    int have = film.samples(pixel);
    if (have == 0) {
      freeze(x, y, slot);
    } else if (film.kind[pixel] == Film.SPLIT) {
      divide(x, y, slot);
    }
    if (film.inlaid[pixel]) {
      inlay.turn(x, y);
    }
    probe.pixel(x, y);
    int total = 1 << level;
    int half = total / 2;
    Focus focus = film.focus[pixel];
    if (focus != null) {
      film.level[pixel] = (byte) level;
      return sample(x, y, slot, focus, have, total);
    }
    for (int i = have; i < total; i++) {
      if (i == half) {
        keepMean(slot);
      }
      add(x, y, slot, i);
    }
    film.level[pixel] = (byte) level;
    return finish(x, y, slot);
  }

  private double sample(int x, int y, int slot, Focus focus, int have, int total) {
    for (int i = have; i < total; i++) {
      if (i == total / 2) {
        focus.mean(before);
      }
      if (focus.sample(probe, x, y, i)) {
        film.valid[slot]++;
        film.cut[slot] += (float) probe.cut();
      }
    }
    focus.mean(mean);
    double moved = 0;
    double variance = 0;
    for (int channel = 0; channel < 3; channel++) {
      moved += scale.squaredDifference(mean[channel], before[channel]);
      variance += scale.squaredError(mean[channel], focus.deviation(channel));
    }
    film.image.set(x, y, mean[0], mean[1], mean[2]);
    film.own[y * film.width + x] = (float) (variance / 3 + focus.unseen());
    return moved / 3;
  }

  private void keepMean(int slot) {
    int count = Math.max(1, film.valid[slot]);
    for (int channel = 0; channel < 3; channel++) {
      int at = Film.SLOT * slot + channel;
      before[channel] = film.sums[at + 6] + film.sums[at] / count;
    }
  }

  /** Settles the model that samples of a pixel are compared with from now on. */
  private void freeze(int x, int y, int slot) {
    int pixel = y * film.width + x;
    film.prior[slot] = film.own[pixel];
    boolean inside = film.insideAsCorner[pixel];
    if (film.kind[pixel] == Film.SPLIT && !split.look(x, y, inside)) {
      film.kind[pixel] = Film.BUSY;
    }
    if (film.kind[pixel] == Film.SPLIT) {
      int at = Film.EDGE * slot;
      film.edge[at] = (float) split.along(0);
      film.edge[at + 1] = (float) split.along(1);
      film.edge[at + 2] = (float) split.bulge();
      divide(x, y, slot);
      film.prior[slot] += (float) split.doubt(scale);
    }
    if (film.inlaid[pixel]) {
      inlay.look(x, y, FINER);
      film.prior[slot] = (float) inlay.variance;
    }
    for (int channel = 0; channel < 3; channel++) {
      film.sums[Film.SLOT * slot + 6 + channel] =
          switch (film.kind[pixel]) {
            case Film.SMOOTH ->
                film.inlaid[pixel] ? inlay.mean[channel] : corners.mean(x, y, channel);
            case Film.SPLIT -> split.mean(channel);
            default -> 0;
          };
    }
  }

  private void divide(int x, int y, int slot) {
    int at = Film.EDGE * slot;
    split.freeze(x, y, film.edge[at], film.edge[at + 1], film.edge[at + 2]);
  }

  private void add(int x, int y, int slot, int number) {
    if (!probe.sample(number)) {
      return;
    }
    film.valid[slot]++;
    predict(x, y);
    add(slot, 0, probe.r());
    add(slot, 1, probe.g());
    add(slot, 2, probe.b());
    film.cut[slot] += (float) probe.cut();
  }

  private void add(int slot, int channel, double radiance) {
    double difference = radiance - model[channel];
    int at = Film.SLOT * slot + channel;
    film.sums[at] += difference;
    film.sums[at + 3] += difference * difference;
  }

  /** Sets {@link #model} to what the pixel's model says at the place of the sample. */
  private void predict(int x, int y) {
    int pixel = y * film.width + x;
    byte kind = film.kind[pixel];
    if (kind == Film.SMOOTH && film.inlaid[pixel]) {
      System.arraycopy(inlay.at(probe.placeX(), probe.placeY()), 0, model, 0, 3);
      return;
    }
    double u = probe.placeX();
    double v = probe.placeY();
    int a = 3 * (y * corners.stride + x);
    int c = a + 3 * corners.stride;
    double[] rgb = corners.rgb;
    for (int i = 0; i < 3; i++) {
      model[i] =
          switch (kind) {
            case Film.SMOOTH ->
                (1 - v) * ((1 - u) * rgb[a + i] + u * rgb[a + 3 + i])
                    + v * ((1 - u) * rgb[c + i] + u * rgb[c + 3 + i]);
            case Film.SPLIT -> split.at(i, u, v);
            default -> 0;
          };
    }
  }

  /** Stores the pixel's mean and the variance of a mean of as many independent samples. */
  private double finish(int x, int y, int slot) {
    int count = Math.max(2, film.valid[slot]);
    double moved = 0;
    double variance = 0;
    for (int channel = 0; channel < 3; channel++) {
      int at = Film.SLOT * slot + channel;
      double difference = film.sums[at] / count;
      // What the model has too much of may be more than there is.
      mean[channel] = Math.max(0, film.sums[at + 6] + difference);
      moved += scale.squaredDifference(mean[channel], before[channel]);
      double squares = film.sums[at + 3] / count - difference * difference;
      double spread = Math.sqrt(Math.max(0, squares) / (count - 1));
      double sum = film.sums[at];
      film.sums[at + 9] = Math.max(0, film.sums[at + 3] - sum * sum / count) / (count - 1);
      variance += scale.squaredError(mean[channel], spread);
    }
    film.image.set(x, y, mean[0], mean[1], mean[2]);
    film.own[y * film.width + x] = (float) (variance / 3);
    return moved / 3;
  }
}
