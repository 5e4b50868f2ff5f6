package glint.render;

import glint.sampling.SobolSampler;
import java.util.Arrays;

/**
 * Where edges cross the sides between neighbouring corners, known to within brackets that shrink;
 * shared by the two pixels beside a side.
 *
 * <p>A bracket is divided near its middle, at a place that depends on the side: an edge that runs
 * along a row of pixels would be wrong by the same amount in all of them otherwise. An edge that
 * runs just along corners is at the very end of its sides: next to there they are divided if the
 * brackets of a pixel say that it may be so.
 */
final class Brackets {

  /** In place of a number of divisions: more than one edge crosses. */
  static final byte MIXED = -1;

  /** Where brackets are divided: from this share of their length up to one less it. */
  private static final double LEAST_SHARE = 0.35;

  /** The same for the first time: edges just through the middle are nothing special then. */
  private static final double FIRST_SHARE = 0.2;

  /** How far apart the places are, in a pixel, at which pixels are looked at. */
  private static final double AMID = 0.3;

  /** How near to a corner that is. */
  private static final float BESIDE_CORNER = 0x1p-12f;

  /** The place of what is known of the sides that nobody has asked for: nothing. */
  private static final int UNKNOWN = 0;

  final Sides sides;
  private final CornerGrid corners;
  private final long seed;

  /** By side, the place of what is known of it. */
  private final int[] place;

  private int places = 1;

  /** By place, the side. */
  private int[] side = new int[256];

  /** How often the bracket was divided. */
  byte[] steps = new byte[256];

  /** Where it begins and ends, 0 to 1 along the side. */
  float[] low = new float[256];

  float[] high = new float[256];

  /** The radiance at both ends. */
  private double[] seen = new double[6 * 256];

  /** Whether it is divided beside a corner next. */
  private boolean[] besideCorner = new boolean[256];

  /** Whether it is divided twice then. */
  private boolean[] twice = new boolean[256];

  /** The places of those that are divided next. */
  private final Selection wanted = new Selection();

  private double atCorner;

  /** Makes the brackets of a grid, nothing known of any. */
  Brackets(CornerGrid corners, long seed) {
    this.corners = corners;
    this.seed = SobolSampler.mix(seed);
    sides = new Sides(corners);
    place = new int[sides.count];
    high[UNKNOWN] = 1;
  }

  /** Returns how often the bracket of a side was divided. */
  int steps(int number) {
    return steps[place[number]];
  }

  /** Returns the middle of a side's bracket. */
  float middle(int number) {
    int at = place[number];
    return 0.5f * (low[at] + high[at]);
  }

  /** Returns where a side's bracket begins. */
  float low(int number) {
    return low[place[number]];
  }

  /** Returns the length of a side's bracket. */
  float length(int number) {
    int at = place[number];
    return high[at] - low[at];
  }

  /**
   * Returns where in a pixel it is looked at, from the left: near the middle, in each pixel
   * elsewhere for the same reason.
   */
  double insideX(int column, int row) {
    return amid(hash(column, row) >>> 32);
  }

  /** Returns where that is from the top. */
  double insideY(int column, int row) {
    return amid(hash(column, row) & 0xffffffffL);
  }

  private long hash(int column, int row) {
    return SobolSampler.mix(seed ^ ((long) row << 32 | column));
  }

  private static double amid(long bits) {
    return 0.5 + AMID * (bits * 0x1p-32 - 0.5);
  }

  /** Asks for a side's bracket to be divided, perhaps beside the corner that it ends at. */
  void want(int number, boolean atCorner, boolean again) {
    int at = open(number);
    wanted.add(at);
    besideCorner[at] |= atCorner;
    twice[at] |= again;
  }

  /** Returns the place of a side, which is given one if it has none. */
  int open(int number) {
    if (place[number] != UNKNOWN) {
      return place[number];
    }
    if (places == side.length) {
      int more = 2 * places;
      side = Arrays.copyOf(side, more);
      steps = Arrays.copyOf(steps, more);
      low = Arrays.copyOf(low, more);
      high = Arrays.copyOf(high, more);
      seen = Arrays.copyOf(seen, 6 * more);
      besideCorner = Arrays.copyOf(besideCorner, more);
      twice = Arrays.copyOf(twice, more);
    }
    int at = places++;
    place[number] = at;
    side[at] = number;
    high[at] = 1;
    System.arraycopy(corners.rgb, 3 * sides.first(number), seen, 6 * at, 3);
    System.arraycopy(corners.rgb, 3 * sides.last(number), seen, 6 * at + 3, 3);
    return at;
  }

  /**
   * Writes the radiance at an end of a side's bracket, as far as is known.
   *
   * @param isHigh whether at the end where it is high
   * @param corner where the side ends there
   * @param out three numbers are set, from an index on
   */
  void beside(int number, boolean isHigh, int corner, double[] out, int index) {
    int at = place[number];
    double[] rgb = at == UNKNOWN ? corners.rgb : seen;
    int from = at == UNKNOWN ? 3 * corner : 6 * at + (isHigh ? 3 : 0);
    out[index] = rgb[from];
    out[index + 1] = rgb[from + 1];
    out[index + 2] = rgb[from + 2];
  }

  /**
   * Learns how probable it is that a bracket that ends at a corner does so because the edge runs
   * just there: from how many do, and how many would by chance.
   *
   * @return whether that is something new
   */
  boolean learn() {
    double before = atCorner;
    int ending = 0;
    double byChance = 0;
    for (int at = 1; at < places; at++) {
      if (steps[at] >= 2) {
        ending += low[at] == 0 || high[at] == 1 ? 1 : 0;
        byChance += Math.scalb(2.0, -steps[at]);
      }
    }
    double atMost = byChance + 2 * Math.sqrt(byChance);
    atCorner = ending > atMost ? 1 - atMost / ending : 0;
    return atCorner != before;
  }

  /** Returns the probability that a bracket's edge runs just along the corner that it ends at. */
  double atCorner(int number) {
    return endsAtCorner(number, 2) ? atCorner : 0;
  }

  /** Returns whether a bracket that was divided so many times still ends at a corner. */
  boolean endsAtCorner(int number, int divided) {
    int at = place[number];
    return steps[at] >= divided && (low[at] == 0 || high[at] == 1);
  }

  /** Returns the sides that were asked for since the last call. */
  int[] wanted() {
    int[] numbers = wanted.take();
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = side[numbers[i]];
    }
    return numbers;
  }

  /** Divides the bracket of a side that an edge crosses, and that was asked for. */
  void divide(Probe probe, int number) {
    int at = place[number];
    divide(probe, number, at);
    if (twice[at]) {
      twice[at] = false;
      divide(probe, number, at);
    }
  }

  private void divide(Probe probe, int number, int at) {
    if (steps[at] == MIXED) {
      return;
    }
    float along = along(at);
    int x = sides.column(number);
    int y = sides.row(number);
    boolean finite =
        sides.isHorizontal(number) ? probe.trace(x + along, y) : probe.trace(x, y + along);
    long met = probe.signature();
    if (finite && met == corners.signature[sides.first(number)]) {
      low[at] = along;
      steps[at]++;
      see(probe, 6 * at);
    } else if (finite && met == corners.signature[sides.last(number)]) {
      high[at] = along;
      steps[at]++;
      see(probe, 6 * at + 3);
    } else {
      steps[at] = MIXED;
    }
  }

  private void see(Probe probe, int at) {
    seen[at] = probe.r();
    seen[at + 1] = probe.g();
    seen[at + 2] = probe.b();
  }

  /** Returns where a bracket is divided next. */
  private float along(int at) {
    if (besideCorner[at]) {
      besideCorner[at] = false;
      return low[at] == 0 ? BESIDE_CORNER : 1 - BESIDE_CORNER;
    }
    long hash = SobolSampler.mix(seed ^ ((long) side[at] << 8 | steps[at]));
    double least = steps[at] == 0 ? FIRST_SHARE : LEAST_SHARE;
    double share = least + (1 - 2 * least) * (hash >>> 11) * 0x1p-53;
    return (float) (low[at] + share * (high[at] - low[at]));
  }
}
