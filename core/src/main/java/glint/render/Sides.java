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

  private int[] list = new int[1024];

  /** All sides that were ever to be divided. */
  private int[] searched = new int[1024];

  private int searches;

  /** The number of a side among those, or -1. */
  private final int[] slot;

  /** For each of those, the radiance at both ends of its bracket. */
  private double[] seen = new double[6 * 1024];

  private int count;

  /** Those of them that are divided beside a corner. */
  private final boolean[] besideCorner;

  /** Makes the sides of a grid, nothing known of any. */
  Sides(CornerGrid corners, long seed) {
    this.seed = SobolSampler.mix(seed);
    this.corners = corners;
    width = corners.stride - 1;
    horizontals = width * corners.rows;
    int all = horizontals + corners.stride * (corners.rows - 1);
    steps = new byte[all];
    low = new float[all];
    high = new float[all];
    Arrays.fill(high, 1);
    slot = new int[all];
    Arrays.fill(slot, -1);
    wanted = new boolean[all];
    besideCorner = new boolean[all];
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

  /** Returns the number of a side of a pixel: 0 top, 1 bottom, 2 left, 3 right. */
  int number(int x, int y, int side) {
    return switch (side) {
      case 0 -> top(x, y);
      case 1 -> bottom(x, y);
      case 2 -> left(x, y);
      default -> right(x, y);
    };
  }

  /** Asks for a side's bracket to be divided, perhaps beside the corner that it ends at. */
  void want(int side, boolean atCorner) {
    if (!wanted[side]) {
      wanted[side] = true;
      if (steps[side] == 0) {
        open(side);
      }
      list = count == list.length ? Arrays.copyOf(list, 2 * count) : list;
      list[count++] = side;
    }
    besideCorner[side] |= atCorner;
  }

  /** Gives a side that is searched for the first time a place for what is seen there. */
  private void open(int side) {
    if (searches == searched.length) {
      searched = Arrays.copyOf(searched, 2 * searches);
      seen = Arrays.copyOf(seen, 6 * searched.length);
    }
    System.arraycopy(corners.rgb, 3 * first(side), seen, 6 * searches, 3);
    System.arraycopy(corners.rgb, 3 * last(side), seen, 6 * searches + 3, 3);
    slot[side] = searches;
    searched[searches++] = side;
  }

  /** Returns the corner where a side begins. */
  private int first(int side) {
    return row(side) * corners.stride + column(side);
  }

  /** Returns the corner where it ends. */
  private int last(int side) {
    return first(side) + (isHorizontal(side) ? 1 : corners.stride);
  }

  /**
   * Returns the radiance at an end of a side's bracket, as far as is known.
   *
   * @param high whether at the end where it is high
   * @param out the last three numbers are set
   */
  void beside(int side, boolean high, double[] out) {
    if (slot[side] < 0) {
      System.arraycopy(corners.rgb, 3 * (high ? last(side) : first(side)), out, 2, 3);
    } else {
      System.arraycopy(seen, 6 * slot[side] + (high ? 3 : 0), out, 2, 3);
    }
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
    for (int i = 0; i < searches; i++) {
      int side = searched[i];
      if (steps[side] >= 2) {
        ending += endsAtCorner(side, 2) ? 1 : 0;
        byChance += Math.scalb(2.0, -steps[side]);
      }
    }
    double atMost = byChance + 2 * Math.sqrt(byChance);
    atCorner = ending > atMost ? 1 - atMost / ending : 0;
    return atCorner != before;
  }

  /** Returns the probability that a bracket's edge runs just along the corner that it ends at. */
  double atCorner(int side) {
    return endsAtCorner(side, 2) ? atCorner : 0;
  }

  /** Returns whether a bracket that was divided so many times still ends at a corner. */
  boolean endsAtCorner(int side, int divided) {
    return steps[side] >= divided && (low[side] == 0 || high[side] == 1);
  }

  /** Returns the sides that were asked for since the last call. */
  int[] wanted() {
    int[] sides = Arrays.copyOf(list, count);
    count = 0;
    return sides;
  }

  /** Returns the column of the pixel below or to the right of a side; there may be none. */
  int column(int side) {
    return side < horizontals ? side % width : (side - horizontals) % corners.stride;
  }

  /** Returns the row of that pixel. */
  int row(int side) {
    return side < horizontals ? side / width : (side - horizontals) / corners.stride;
  }

  boolean isHorizontal(int side) {
    return side < horizontals;
  }

  /** Divides the bracket of a side that an edge crosses. */
  void divide(Probe probe, int side) {
    wanted[side] = false;
    if (steps[side] == MIXED) {
      return;
    }
    float place = place(side);
    int x = column(side);
    int y = row(side);
    boolean finite = isHorizontal(side) ? probe.trace(x + place, y) : probe.trace(x, y + place);
    long met = probe.signature();
    if (finite && met == corners.signature[first(side)]) {
      low[side] = place;
      steps[side]++;
      see(probe, 6 * slot[side]);
    } else if (finite && met == corners.signature[last(side)]) {
      high[side] = place;
      steps[side]++;
      see(probe, 6 * slot[side] + 3);
    } else {
      steps[side] = MIXED;
    }
  }

  private void see(Probe probe, int at) {
    seen[at] = probe.r();
    seen[at + 1] = probe.g();
    seen[at + 2] = probe.b();
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
