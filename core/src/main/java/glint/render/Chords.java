package glint.render;

/**
 * The chords that the edge in a pixel may have between two sides, for all that is known: they end
 * in the brackets of both, and pass the place in the pixel that was looked at on the side where it
 * was seen to be; scratch.
 */
final class Chords {

  /** For the first end, that many places stand for all in its bracket. */
  private static final int STRIPS = 4;

  private final Brackets brackets;

  /** Which side of the pixel each end is on: 0 top, 1 bottom, 2 left, 3 right. */
  private final int[] which;

  /** Where the pixel was looked at, from its upper left corner. */
  double insideX;

  double insideY;

  /** Whether the place looked at shall have the sign that chords here do not give it. */
  private boolean turned;

  /** Where the mean of the chords ends, 0 to 1 along the sides. */
  double one;

  double two;

  /** The mean of the share of the pixel on the side of its upper left corner. */
  double area;

  /** The variance of that share. */
  double variance;

  /** By how much it may be off if the edge runs just along the corners where both brackets end. */
  double most;

  /**
   * Makes chords between sides that change with the numbers given.
   *
   * @param which the two sides, as in {@link Sides#number}, the lesser first
   */
  Chords(Brackets brackets, int[] which) {
    this.brackets = brackets;
    this.which = which;
  }

  /**
   * Finds the mean of all chords.
   *
   * @param crossed the numbers of the two sides
   * @param insideAsCorner whether the place looked at is of a kind with the upper left corner
   */
  void look(int column, int row, int[] crossed, boolean insideAsCorner) {
    double low = brackets.low(crossed[0]);
    double length = brackets.length(crossed[0]);
    double least = brackets.low(crossed[1]);
    double reach = brackets.length(crossed[1]);
    one = low + 0.5 * length;
    two = least + 0.5 * reach;
    insideX = brackets.insideX(column, row);
    insideY = brackets.insideY(column, row);
    turned = side(one, two, 0, 0) < 0 == insideAsCorner;
    area = area(one, two);
    double range = Math.abs(area(low + length, two) - area(low, two));
    double other = Math.abs(area(one, least + reach) - area(one, least));
    most = 0.5 * (range + other);
    variance = (range * range + other * other) / 12; // of numbers even in ranges
    if (mayPassOnEitherSide(low, length, least, reach)) {
      narrow(low, length, least, reach);
    }
  }

  private boolean mayPassOnEitherSide(double low, double length, double least, double reach) {
    boolean first = passes(low, least) >= 0;
    return first != passes(low + length, least) >= 0
        || first != passes(low, least + reach) >= 0
        || first != passes(low + length, least + reach) >= 0;
  }

  /**
   * Leaves out the chords that pass on the wrong side. For each place of the first end, how far
   * they pass, and the area, are even along the bracket of the second.
   */
  private void narrow(double low, double length, double least, double reach) {
    double weights = 0;
    double ones = 0;
    double twos = 0;
    double areas = 0;
    double squares = 0;
    for (int strip = 0; strip < STRIPS; strip++) {
      double here = low + length * (strip + 0.5) / STRIPS;
      double first = passes(here, least);
      double last = passes(here, least + reach);
      double between = first / (first - last);
      double from = first >= 0 ? 0 : last > 0 ? between : 1;
      double to = last >= 0 ? 1 : first > 0 ? between : 0;
      double weight = Math.max(0, to - from);
      double there = least + reach * 0.5 * (from + to);
      double share = area(here, there);
      double range = area(here, least + reach * to) - area(here, least + reach * from);
      weights += weight;
      ones += weight * here;
      twos += weight * there;
      areas += weight * share;
      squares += weight * (share * share + range * range / 12);
    }
    if (weights > 0) {
      one = ones / weights;
      two = twos / weights;
      area = areas / weights;
      variance = Math.max(0, squares / weights - area * area);
    }
  }

  /** Returns by how far a chord passes the place looked at on the side where it should. */
  private double passes(double one, double two) {
    double side = side(one, two, insideX, insideY);
    return turned ? -side : side;
  }

  /** Returns twice the signed area of the triangle of a chord and a place. */
  private double side(double one, double two, double u, double v) {
    double x = which[0] < 2 ? one : which[0] - 2;
    double y = which[0] < 2 ? which[0] : one;
    double dx = (which[1] < 2 ? two : which[1] - 2) - x;
    double dy = (which[1] < 2 ? which[1] : two) - y;
    return dx * (v - y) - dy * (u - x);
  }

  /**
   * Returns the share of the pixel on the side of its upper left corner if the edge is straight,
   * and crosses the two sides at places 0 to 1 along them.
   */
  double area(double one, double two) {
    if (which[0] >> 1 == which[1] >> 1) {
      return 0.5 * (one + two);
    }
    double dx = which[1] == 2 ? one : 1 - one;
    double dy = which[0] == 0 ? two : 1 - two;
    double cornerCut = 0.5 * dx * dy;
    return which[0] == 0 && which[1] == 2 ? cornerCut : 1 - cornerCut;
  }
}
