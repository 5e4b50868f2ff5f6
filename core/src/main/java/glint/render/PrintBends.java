package glint.render;

import java.util.Arrays;

/**
 * Tells from second differences how evenly an image runs over a pixel, like {@link Bends}; scratch.
 */
final class PrintBends {

  /** A step counts as so many bends: 12/√12, see {@link Bends}. */
  private static final double STEP = 2 * Math.sqrt(3);

  private static final double TWENTY_FOURTH = 1 / 24.0;

  private final CornerGrid corners;

  /** The second differences along the sides, without their signs and summed up, by number. */
  private final double[] bends = new double[Prints.NUMBERS];

  PrintBends(CornerGrid corners) {
    this.corners = corners;
  }

  /** Finds the bends of the four sides; returns whether enough around is of a kind for that. */
  boolean find(int x, int y) {
    int a = y * corners.stride + x;
    int c = a + corners.stride;
    Arrays.fill(bends, 0);
    return add(a, 1, x, corners.stride)
        && add(c, 1, x, corners.stride)
        && add(a, corners.stride, y, corners.rows)
        && add(a + 1, corners.stride, y, corners.rows);
  }

  /** Returns by how much the image lies elsewhere than if it ran evenly: in its pixels. */
  double elsewhere() {
    return TWENTY_FOURTH * Math.sqrt(bends[0] * bends[0] + bends[1] * bends[1]);
  }

  /** Returns the error of a channel's mean by the light that falls there, and by all the rest. */
  double error(int channel, double colour) {
    return TWENTY_FOURTH * (bends[Prints.REST + channel] + bends[Prints.GAIN + channel] * colour);
  }

  /** Adds the bends of a side, like {@link Bends}; returns whether there is anything beside it. */
  private boolean add(int corner, int step, int at, int count) {
    long[] met = corners.signature;
    double[] seen = corners.prints.seen;
    boolean before = at > 0 && met[corner - step] == met[corner];
    boolean after = at + 2 < count && met[corner + 2 * step] == met[corner];
    int next = Prints.NUMBERS * step;
    for (int number = 0; number < Prints.NUMBERS; number++) {
      int i = Prints.NUMBERS * corner + number;
      double one = seen[i];
      double two = seen[i + next];
      double first = before ? seen[i - next] - 2 * one + two : 0;
      double last = after ? one - 2 * two + seen[i + 2 * next] : 0;
      boolean both = before && after;
      double bend = Math.abs(first + last);
      bends[number] += both ? 0.5 * (bend + STEP * Math.abs(first - last)) : bend;
    }
    return before || after;
  }
}
