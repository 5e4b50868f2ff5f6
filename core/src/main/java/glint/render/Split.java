package glint.render;

/**
 * A pixel that one edge divides in two, taken for an arc between the two sides that it crosses, or
 * for straight; scratch.
 */
final class Split {

  /** What lies nearer to an edge than this, in pixels, may be on either side. */
  private static final double NEAR = 0.02;

  private final CornerGrid corners;
  private final Sides sides;

  /** The two sides crossed, as numbers of {@link Sides}. */
  private final int[] crossed = new int[2];

  /** Where the edge meets them, in the pixel. */
  private final double[] x = new double[2];

  private final double[] y = new double[2];

  /** Which side of the pixel each is: 0 top, 1 bottom, 2 left, 3 right. */
  private final int[] which = new int[2];

  private final Parts parts;

  /** The mean colour on the side of the upper left corner, and on the other. */
  private final double[] first;

  private final double[] second;

  /** By how much a curved edge covers more than its chord, on the side of the upper left corner. */
  private double bulge;

  /** The uncertainty of that. */
  private double doubt;

  /** Twice the signed area of the triangle of the edge and the upper left corner. */
  private double orientation;

  Split(CornerGrid corners, Sides sides) {
    this.corners = corners;
    this.sides = sides;
    parts = new Parts(corners, sides);
    first = parts.first;
    second = parts.second;
  }

  /**
   * Looks at a pixel two of whose sides have different ends.
   *
   * @return whether each of the two is crossed once, as far as is known
   */
  boolean look(int column, int row) {
    boolean once = cross(column, row);
    place(sides.middle(crossed[0]), sides.middle(crossed[1]));
    parts.fromSearch(column, row, which, x, y);
    bend(column, row);
    doubt += isInside(bulge) ? 0 : Math.abs(bulge);
    return once;
  }

  /** Finds the two sides only; returns whether each is crossed once, as far as is known. */
  boolean cross(int column, int row) {
    int count = 0;
    for (int side = 0; side < 4; side++) {
      if (isCrossed(column, row, side)) {
        which[count] = side;
        crossed[count++] = sides.number(column, row, side);
      }
    }
    return steps() != Sides.MIXED;
  }

  /**
   * Finds how the edge curves from what it does in the two neighbours: like a circle, which covers
   * L³κ/12 more than its chord of length L, if both turn the same way.
   */
  private void bend(int column, int row) {
    double one = curvature(column, row, 0);
    double two = curvature(column, row, 1);
    double dx = x[1] - x[0];
    double dy = y[1] - y[0];
    double length = Math.sqrt(dx * dx + dy * dy);
    double unit = length * length * length / 12;
    double common = one * two > 0 ? Math.copySign(Math.min(Math.abs(one), Math.abs(two)), one) : 0;
    bulge = unit * (orientation > 0 ? common : -common);
    doubt = unit * Math.max(Math.abs(one - common), Math.abs(two - common)) / 2;
  }

  /** Returns by how much the edge turns to the left per length where it leaves the pixel, or 0. */
  private double curvature(int column, int row, int end) {
    int nextX = column + (which[end] == 3 ? 1 : 0) - (which[end] == 2 ? 1 : 0);
    int nextY = row + (which[end] == 1 ? 1 : 0) - (which[end] == 0 ? 1 : 0);
    if (nextX < 0 || nextY < 0 || nextX >= corners.stride - 1 || nextY >= corners.rows - 1) {
      return 0;
    }
    int from = which[end] ^ 1; // the same side, seen from the neighbour
    int other = -1;
    for (int side = 0; side < 4; side++) {
      if (side != from && isCrossed(nextX, nextY, side)) {
        if (other >= 0) {
          return 0;
        }
        other = side;
      }
    }
    int number = other < 0 ? -1 : sides.number(nextX, nextY, other);
    if (other < 0 || sides.steps[number] == Sides.MIXED) {
      return 0;
    }
    double along = sides.middle(number);
    double px = nextX - column + (other < 2 ? along : other - 2);
    double py = nextY - row + (other < 2 ? other : along);
    double dx = x[1] - x[0];
    double dy = y[1] - y[0];
    double ex = end == 1 ? px - x[1] : x[0] - px;
    double ey = end == 1 ? py - y[1] : y[0] - py;
    double d = Math.sqrt(dx * dx + dy * dy);
    double e = Math.sqrt(ex * ex + ey * ey);
    double turn = end == 1 ? dx * ey - dy * ex : ex * dy - ey * dx;
    return d > 0 && e > 0 ? 2 * turn / (d * e * (d + e)) : 0;
  }

  private boolean isCrossed(int column, int row, int side) {
    int a = row * corners.stride + column + (side == 3 ? 1 : 0);
    a += side == 1 ? corners.stride : 0;
    int b = a + (side < 2 ? 1 : corners.stride);
    return corners.signature[a] != corners.signature[b];
  }

  /**
   * Divides a pixel by an arc, in two plain colours that no better knowledge changes.
   *
   * @param arc its bulge, which is left out, and doubtful, if it is not surely in the pixel
   */
  void freeze(int column, int row, double one, double two, double arc) {
    cross(column, row);
    place(one, two);
    bulge = isInside(arc) ? arc : 0;
    doubt = Math.abs(arc - bulge);
    parts.fromCorners(column, row);
  }

  /** Returns the {@link #bulge}. */
  double bulge() {
    return bulge;
  }

  /**
   * Returns whether the parabola that covers so much more than its chord surely stays in the pixel:
   * it does if its control point is in it, which is twice as far from the chord.
   */
  private boolean isInside(double arc) {
    double dx = x[1] - x[0];
    double dy = y[1] - y[0];
    double away = 3 * (orientation > 0 ? -arc : arc) / (dx * dx + dy * dy);
    double controlX = 0.5 * (x[0] + x[1]) - away * dy;
    double controlY = 0.5 * (y[0] + y[1]) + away * dx;
    return controlX >= 0 && controlX <= 1 && controlY >= 0 && controlY <= 1;
  }

  /** Has a straight edge cross the two sides elsewhere: 0 to 1 along them. */
  private void place(double one, double two) {
    bulge = 0;
    doubt = 0;
    place(0, one);
    place(1, two);
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
    return Math.min(sides.steps[crossed[0]], sides.steps[crossed[1]]);
  }

  /** Returns the share of the pixel on the side of its upper left corner. */
  private double area() {
    if (which[0] == 0 && which[1] == 1) {
      return 0.5 * (x[0] + x[1]);
    }
    if (which[0] == 2) {
      return 0.5 * (y[0] + y[1]);
    }
    double dx = which[1] == 2 ? x[0] : 1 - x[0];
    double dy = which[0] == 0 ? y[1] : 1 - y[1];
    double cornerCut = 0.5 * dx * dy;
    return which[0] == 0 && which[1] == 2 ? cornerCut : 1 - cornerCut;
  }

  /** Returns the mean of a channel over the pixel. */
  double mean(int channel) {
    double share = Math.min(Math.max(area() + bulge, 0), 1);
    return share * first[channel] + (1 - share) * second[channel];
  }

  /** Returns the radiance of a channel at a place in the pixel. */
  double at(int channel, double u, double v) {
    boolean near = (side(u, v) < arc(u, v)) == (orientation < 0);
    return near ? first[channel] : second[channel];
  }

  /** Returns how far to the side the arc lies beside a place, as a parabola of the same bulge. */
  private double arc(double u, double v) {
    double dx = x[1] - x[0];
    double dy = y[1] - y[0];
    double along = ((u - x[0]) * dx + (v - y[0]) * dy) / (dx * dx + dy * dy);
    double height = along > 0 && along < 1 ? 6 * bulge * along * (1 - along) : 0;
    return orientation > 0 ? -height : height;
  }

  /**
   * Returns whether the middle of the pixel is on the side of the edge where it was seen to be, or
   * so near to it that nobody knows.
   */
  boolean agrees(boolean middleAsCorner) {
    double dx = x[1] - x[0];
    double dy = y[1] - y[0];
    double length = Math.sqrt(dx * dx + dy * dy);
    double bracket = Math.max(sides.length(crossed[0]), sides.length(crossed[1]));
    double sag = 1.5 * (Math.abs(bulge) + doubt);
    double middle = side(0.5, 0.5);
    boolean near = Math.abs(middle) <= length * (bracket + NEAR) + sag;
    return near || (middle < 0) == (orientation < 0) == middleAsCorner;
  }

  private double side(double u, double v) {
    return (x[1] - x[0]) * (v - y[0]) - (y[1] - y[0]) * (u - x[0]);
  }

  /**
   * Returns the variance of the mean, in levels², by what is not known of where the edge meets the
   * sides: it may be anywhere in its brackets, or run just along the corners that both end at.
   */
  double variance(LevelScale scale) {
    double atCorner = Math.min(sides.atCorner(crossed[0]), sides.atCorner(crossed[1]));
    double variance = 0;
    double sum = 0;
    for (int i = 0; i < 2; i++) {
      double along = along(i);
      double half = 0.5 * sides.length(crossed[i]);
      place(i, along + half);
      double more = area();
      place(i, along - half);
      double range = more - area();
      place(i, along);
      variance += range * range / 12; // of a number even in a range
      sum += Math.abs(range) / 2;
    }
    variance += atCorner * (sum * sum - variance);
    return inLevels(scale, Math.sqrt(variance));
  }

  /** Returns the variance of the mean, in levels², by what is not known of how the edge curves. */
  double doubt(LevelScale scale) {
    return inLevels(scale, doubt);
  }

  private double inLevels(LevelScale scale, double error) {
    double sum = 0;
    for (int channel = 0; channel < 3; channel++) {
      sum += scale.squaredError(mean(channel), error * (first[channel] - second[channel]));
    }
    return sum / 3;
  }
}
