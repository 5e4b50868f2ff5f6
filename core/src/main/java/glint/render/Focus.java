package glint.render;

/**
 * One or two parts of a pixel that are sampled by themselves, as something small is seen there:
 * samples are shared out among them and the rest of the pixel, and count by area (stratified
 * sampling).
 */
final class Focus {

  /** Sum and sum of squares of a stratum, by channel. */
  private static final int NUMBERS = 6;

  /** A second part of which less is its own is no part. */
  private static final double OWN = 0.1;

  /** What is sampled by itself first, and what of the second is not in the first; may be empty. */
  private final ConvexPolygon first;

  private final ConvexPolygon second;

  /** The area of each stratum: the rest of the pixel, the first part, the second. */
  private final double[] areas;

  private final double[] sums;

  /** How many places were drawn, and how many finite samples there are, by stratum. */
  private final int[] drawn;

  private final int[] counts;

  /** The place, in the image, of the last sample. */
  private double placeX;

  private double placeY;

  /** What share of what is missing, squared, the first guess may be wrong by. */
  private static final double DOUBT = 0.03;

  /** What share of the variance of the corners it may be wrong by in the rest of the pixel. */
  private static final double REST = 0.3;

  /** The pixel as far as one ray for each thing says. */
  final double[] guess;

  /** How wrong that may be in the parts, and in the rest of the pixel: the squares, in levels². */
  private final double doubt;

  private final double restDoubt;

  /**
   * Sets up the parts, in places of the image; the second may be empty.
   *
   * @param guess the radiance of the pixel as far as it is known
   * @param missing by how much that is off the pixel's corners: the square, in levels²
   * @param contrast the variance of the corners where the parts are not, in levels²
   */
  Focus(
      ConvexPolygon first, ConvexPolygon second, double[] guess, double missing, double contrast) {
    this.guess = guess;
    doubt = DOUBT * missing;
    ConvexPolygon common = new ConvexPolygon();
    common.intersect(first, second);
    double own = Math.max(0, second.area() - common.area());
    boolean two = own > OWN * second.area();
    if (!two && !second.isEmpty()) {
      first.add(second);
      first.close();
    }
    this.first = first;
    this.second = second;
    double area = first.area();
    areas = two ? new double[] {1 - area - own, area, own} : new double[] {1 - area, area};
    restDoubt = REST * contrast * areas[0] * areas[0];
    sums = new double[NUMBERS * areas.length];
    drawn = new int[areas.length];
    counts = new int[areas.length];
  }

  /** Returns which share of the pixel the parts cover. */
  double area() {
    return 1 - areas[0];
  }

  /** Takes a sample of a pixel; those that follow each other go into different strata. */
  boolean sample(Probe probe, int x, int y, int number) {
    int stratum = number % areas.length;
    place(probe, x, y, stratum);
    if (!probe.traceSample(placeX, placeY)) {
      return false;
    }
    counts[stratum]++;
    add(stratum, 0, probe.r());
    add(stratum, 1, probe.g());
    add(stratum, 2, probe.b());
    return true;
  }

  /** Turns to the next sample of a stratum, and to its place. */
  private void place(Probe probe, int x, int y, int stratum) {
    while (true) {
      probe.turn(drawn[stratum]++);
      placeX = x + probe.placeX();
      placeY = y + probe.placeY();
      if (stratum > 0) {
        ConvexPolygon part = stratum == 1 ? first : second;
        part.pick(probe.placeX(), probe.placeY());
        placeX = part.px;
        placeY = part.py;
      }
      boolean taken = stratum != 1 && first.contains(placeX, placeY);
      if (!taken && (stratum != 0 || !second.contains(placeX, placeY))) {
        return;
      }
    }
  }

  private void add(int stratum, int channel, double radiance) {
    sums[NUMBERS * stratum + channel] += radiance;
    sums[NUMBERS * stratum + 3 + channel] += radiance * radiance;
  }

  /** Writes the mean radiance of the pixel. */
  void mean(double[] rgb) {
    for (int channel = 0; channel < 3; channel++) {
      rgb[channel] = 0;
      for (int stratum = 0; stratum < areas.length; stratum++) {
        rgb[channel] += areas[stratum] * mean(stratum, channel);
      }
    }
  }

  private double mean(int stratum, int channel) {
    return sums[NUMBERS * stratum + channel] / Math.max(1, counts[stratum]);
  }

  /** Returns the standard deviation of that mean if samples were independent in each part. */
  double deviation(int channel) {
    double variance = 0;
    for (int stratum = 0; stratum < areas.length; stratum++) {
      double mean = mean(stratum, channel);
      int n = Math.max(2, counts[stratum]);
      double squares = sums[NUMBERS * stratum + 3 + channel] / n;
      variance += areas[stratum] * areas[stratum] * Math.max(0, squares - mean * mean) / (n - 1);
    }
    return Math.sqrt(variance);
  }

  /**
   * Returns the variance, in levels², of what is not known without samples, or may be missed by
   * them: as with an area of which nothing is known, it falls with the square of their number.
   */
  double unseen() {
    double n = counts[1] + 1;
    double rest = counts[0] + 1;
    return doubt / (n * n) + restDoubt / (rest * rest);
  }
}
