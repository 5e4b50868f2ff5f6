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
 *
 * <p>Horizontal sides come first: that from corner (x, y) to (x + 1, y) is number {@code y width +
 * x}. Then the vertical ones, from (x, y) to (x, y + 1).
 */
final class Sides {

  /** In place of a number of divisions: more than one edge crosses. */
  static final byte MIXED = -1;

  /** Where brackets are divided: from this share of their length up to one less it. */
  private static final double LEAST_SHARE = 0.35;

  /** The same for the first time: edges just through the middle are nothing special then. */
  private static final double FIRST_SHARE = 0.2;

  /** How near to a corner that is. */
  private static final float BESIDE_CORNER = 0x1p-12f;

  private final CornerGrid corners;
  private final int width;
  private final int horizontals;

  /** How often the bracket of a side was divided. */
  final byte[] steps;

  /** Where the bracket begins and ends, 0 to 1 along the side. */
  final float[] low;

  final float[] high;
  private final long seed;
  private double atCorner;

  /** Sides whose brackets are divided next. */
  private final boolean[] wanted;

  /** Those of them that are divided beside a corner. */
  private final boolean[] besideCorner;

  /** Makes the sides of a grid, nothing known of any. */
  Sides(CornerGrid corners, long seed) {
    this.seed = SobolSampler.mix(seed);
    this.corners = corners;
    width = corners.stride - 1;
    horizontals = width * corners.rows;
    int count = horizontals + corners.stride * (corners.rows - 1);
    steps = new byte[count];
    low = new float[count];
    high = new float[count];
    Arrays.fill(high, 1);
    wanted = new boolean[count];
    besideCorner = new boolean[count];
  }

  int top(int x, int y) {
    return y * width + x;
  }

  int bottom(int x, int y) {
    return top(x, y + 1);
  }

  int left(int x, int y) {
    return horizontals + y * corners.stride + x;
  }

  int right(int x, int y) {
    return left(x + 1, y);
  }

  /** Asks for a side's bracket to be divided, perhaps beside the corner that it ends at. */
  void want(int side, boolean atCorner) {
    wanted[side] = true;
    besideCorner[side] |= atCorner;
  }

  /**
   * Learns how probable it is that a bracket that ends at a corner does so because the edge runs
   * just there: from how many do, and how many would by chance.
   */
  void learn() {
    int ending = 0;
    double byChance = 0;
    for (int side = 0; side < steps.length; side++) {
      if (steps[side] >= 2) {
        ending += endsAtCorner(side, 2) ? 1 : 0;
        byChance += Math.scalb(2.0, -steps[side]);
      }
    }
    double atMost = byChance + 2 * Math.sqrt(byChance);
    atCorner = ending > atMost ? 1 - atMost / ending : 0;
  }

  /** Returns the probability that a bracket's edge runs just along the corner that it ends at. */
  double atCorner(int side) {
    return endsAtCorner(side, 2) ? atCorner : 0;
  }

  /** Returns whether a bracket that was divided so many times still ends at a corner. */
  boolean endsAtCorner(int side, int divided) {
    return steps[side] >= divided && (low[side] == 0 || high[side] == 1);
  }

  /** Returns the sides that were asked for, in order, and forgets that they were. */
  int[] wanted() {
    int count = 0;
    for (boolean each : wanted) {
      count += each ? 1 : 0;
    }
    int[] list = new int[count];
    for (int side = 0, i = 0; i < count; side++) {
      if (wanted[side]) {
        wanted[side] = false;
        list[i++] = side;
      }
    }
    return list;
  }

  /** Divides the bracket of a side that an edge crosses. */
  void divide(Probe probe, int side) {
    if (steps[side] == MIXED) {
      return;
    }
    float place = place(side);
    int first;
    boolean finite;
    int step;
    if (side < horizontals) {
      int y = side / width;
      int x = side % width;
      first = y * corners.stride + x;
      step = 1;
      finite = probe.trace(x + place, y);
    } else {
      int y = (side - horizontals) / corners.stride;
      int x = (side - horizontals) % corners.stride;
      first = y * corners.stride + x;
      step = corners.stride;
      finite = probe.trace(x, y + place);
    }
    long met = probe.signature();
    if (finite && met == corners.signature[first]) {
      low[side] = place;
      steps[side]++;
    } else if (finite && met == corners.signature[first + step]) {
      high[side] = place;
      steps[side]++;
    } else {
      steps[side] = MIXED;
    }
  }

  private float place(int side) {
    if (besideCorner[side]) {
      besideCorner[side] = false;
      return low[side] == 0 ? BESIDE_CORNER : 1 - BESIDE_CORNER;
    }
    long hash = SobolSampler.mix(seed ^ ((long) side << 8 | steps[side]));
    double least = steps[side] == 0 ? FIRST_SHARE : LEAST_SHARE;
    double share = least + (1 - 2 * least) * (hash >>> 11) * 0x1p-53;
    return (float) (low[side] + share * (high[side] - low[side]));
  }

  /** Returns the middle of a side's bracket. */
  float middle(int side) {
    return 0.5f * (low[side] + high[side]);
  }

  /** Returns the length of a side's bracket. */
  float length(int side) {
    return high[side] - low[side];
  }
}
