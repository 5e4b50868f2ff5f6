package glint.render;

/**
 * A pixel that one edge divides in two, taken for an arc between the two sides that it crosses, or
 * for straight; scratch.
 */
final class Split {

  /** What lies nearer to an edge than this, in pixels, may be on either side. */
  private static final double NEAR = 0.02;

  private final CornerGrid corners;
  private final Brackets brackets;
  private final Arc arc;

  /** The two sides crossed, as numbers of {@link Sides}. */
  private final int[] crossed = new int[2];

  /** Where the edge meets them, in the pixel. */
  private final double[] x = new double[2];

  private final double[] y = new double[2];

  /** Which side of the pixel each is: 0 top, 1 bottom, 2 left, 3 right. */
  private final int[] which = new int[2];

  private final Chords chords;
  private final Parts parts;

  /** The mean colour on the side of the upper left corner, and on the other. */
  private final double[] first;

  private final double[] second;

  /** Twice the signed area of the triangle of the edge and the upper left corner. */
  private double orientation;

  /** The mean colour of the pixel. */
  private final double[] mean = new double[3];

  Split(CornerGrid corners, Brackets brackets) {
    this.corners = corners;
    this.brackets = brackets;
    chords = new Chords(brackets, which);
    arc = new Arc(corners, brackets, which, x, y);
    parts = new Parts(corners, brackets);
    first = parts.first;
    second = parts.second;
  }

  /**
   * Looks at a pixel two of whose sides have different ends.
   *
   * @param insideAsCorner whether the place looked at in the pixel is of a kind with its upper left
   *     corner
   * @return whether each of the two sides is crossed once, as far as is known
   */
  boolean look(int column, int row, boolean insideAsCorner) {
    boolean once = cross(column, row);
    chords.look(column, row, crossed, insideAsCorner);
    place(chords.one, chords.two);
    parts.fromSearch(column, row, which, x, y);
    arc.look(column, row, orientation);
    mix(chords.area);
    return once;
  }

  /** Finds the two sides only; returns whether each is crossed once, as far as is known. */
  boolean cross(int column, int row) {
    int sides = corners.crossed(column, row);
    which[0] = Integer.numberOfTrailingZeros(sides);
    which[1] = Integer.numberOfTrailingZeros(sides & sides - 1);
    crossed[0] = brackets.sides.number(column, row, which[0]);
    crossed[1] = brackets.sides.number(column, row, which[1]);
    return steps() != Brackets.MIXED;
  }

  /**
   * Divides a pixel by an arc, in two plain colours that no better knowledge changes.
   *
   * @param bulge of the arc, which is left out, and doubtful, if it is not surely in the pixel
   */
  void freeze(int column, int row, double one, double two, double bulge) {
    cross(column, row);
    place(one, two);
    arc.freeze(bulge, orientation);
    parts.fromCorners(column, row, which);
    mix(chords.area(one, two));
  }

  /** Returns by how much the edge covers more than a straight one, as {@link #freeze} takes it. */
  double bulge() {
    return arc.bulge();
  }

  /** Has the edge cross the two sides elsewhere: 0 to 1 along them. */
  private void place(double one, double two) {
    place(0, one);
    place(1, two);
    arc.measure();
    orientation = side(0, 0);
  }

  /** Returns where the edge crosses one of the two sides, 0 to 1 along it. */
  double along(int i) {
    return which[i] < 2 ? x[i] : y[i];
  }

  private void place(int i, double along) {
    x[i] = which[i] < 2 ? along : which[i] - 2;
    y[i] = which[i] < 2 ? which[i] : along;
  }

  /** Returns the number of one of the two sides crossed. */
  int crossed(int i) {
    return crossed[i];
  }

  /** Returns how often the less known of the two brackets was divided. */
  int steps() {
    return Math.min(brackets.steps(crossed[0]), brackets.steps(crossed[1]));
  }

  /**
   * Finds the mean of the two parts.
   *
   * @param straight the share of the first if the edge is straight
   */
  private void mix(double straight) {
    double share = Math.min(Math.max(straight + arc.bulge(), 0), 1);
    for (int channel = 0; channel < 3; channel++) {
      mean[channel] = share * first[channel] + (1 - share) * second[channel];
    }
  }

  /** Returns the mean of a channel over the pixel. */
  double mean(int channel) {
    return mean[channel];
  }

  /** Returns the radiance of a channel at a place in the pixel. */
  double at(int channel, double u, double v) {
    boolean near = (side(u, v) < arc.beside(u, v)) == (orientation < 0);
    return near ? first[channel] : second[channel];
  }

  /**
   * Returns whether the place looked at in the pixel is on the side of the edge where it was seen
   * to be, or so near to it that nobody knows.
   */
  boolean agrees(boolean insideAsCorner) {
    double bracket = Math.max(brackets.length(crossed[0]), brackets.length(crossed[1]));
    double sag = 1.5 * (Math.abs(arc.bulge()) + arc.doubt());
    double inside = side(chords.insideX, chords.insideY);
    boolean near = Math.abs(inside) <= arc.length() * (bracket + NEAR) + sag;
    return near || (inside < 0) == (orientation < 0) == insideAsCorner;
  }

  private double side(double u, double v) {
    return (x[1] - x[0]) * (v - y[0]) - (y[1] - y[0]) * (u - x[0]);
  }

  /**
   * Returns the variance of the mean, in levels², by what is not known of where the edge meets the
   * sides: it may be anywhere in its brackets, or run just along the corners that both end at.
   */
  double variance(LevelScale scale) {
    double atCorner = Math.min(brackets.atCorner(crossed[0]), brackets.atCorner(crossed[1]));
    double variance = chords.variance;
    variance += atCorner * (chords.most * chords.most - variance);
    return inLevels(scale, Math.sqrt(variance));
  }

  /** Returns the variance of the mean, in levels², by what is not known of how the edge curves. */
  double doubt(LevelScale scale) {
    return inLevels(scale, arc.doubt());
  }

  private double inLevels(LevelScale scale, double error) {
    double sum = 0;
    for (int channel = 0; channel < 3; channel++) {
      sum += scale.squaredError(mean[channel], error * (first[channel] - second[channel]));
    }
    return sum / 3;
  }
}
