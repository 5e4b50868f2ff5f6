package glint.color;

import java.util.Arrays;

/**
 * The codes of the sRGB curve without its power function: the least linear value of every code.
 *
 * <p>They are found by bisection of the curve itself, which never falls as it is computed (the
 * power function of StrictMath is semi-monotonic), so that the codes are the same for every value.
 */
final class SrgbCodes {

  private static final int CODES = 256;

  /** Parts of [0, 1] in each of which the search begins at one code; few have two limits. */
  private static final int PARTS = 4096;

  /** The least value of each code; one more, which no value reaches, ends the search. */
  private static final double[] LEAST = new double[CODES + 1];

  private static final short[] FIRST = new short[PARTS + 1];

  static {
    for (int code = 1; code < CODES; code++) {
      LEAST[code] = leastOf(code);
    }
    LEAST[CODES] = Double.POSITIVE_INFINITY;
    for (int part = 0; part <= PARTS; part++) {
      int found = Arrays.binarySearch(LEAST, (double) part / PARTS);
      FIRST[part] = (short) (found >= 0 ? found : -found - 2);
    }
  }

  private SrgbCodes() {}

  /** Returns the code of a value in [0, 1]. */
  static int of(double linear) {
    int code = FIRST[(int) (linear * PARTS)];
    while (linear >= LEAST[code + 1]) {
      code++;
    }
    return code;
  }

  /** Returns the code as the curve gives it. */
  static int byCurve(double linear) {
    return (int) (255 * Transfer.SRGB.encode(linear) + 0.5);
  }

  /** Positive doubles are ordered as their bits are. */
  private static double leastOf(int code) {
    long below = 0;
    long reached = Double.doubleToLongBits(1);
    while (reached - below > 1) {
      long middle = (below + reached) >>> 1;
      if (byCurve(Double.longBitsToDouble(middle)) >= code) {
        reached = middle;
      } else {
        below = middle;
      }
    }
    return Double.longBitsToDouble(reached);
  }
}
