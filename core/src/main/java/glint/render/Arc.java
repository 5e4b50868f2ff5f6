package glint.render;

/**
 * The edge in a pixel that two of its sides are crossed by, as an arc over the chord between them;
 * how it curves is known from the two neighbours that it goes on in; scratch.
 */
final class Arc {

  private final CornerGrid corners;
  private final Brackets brackets;

  /** Which side of the pixel is crossed at either end: 0 top, 1 bottom, 2 left, 3 right. */
  private final int[] which;

  /** Where the edge meets them, in the pixel. */
  private final double[] x;

  private final double[] y;

  /** Whether the upper left corner is to the left of the chord. */
  private boolean cornerLeft;

  /** The chord. */
  private double dx;

  private double dy;
  private double squared;
  private double length;

  private double bulge;
  private double doubt;

  /**
   * Makes an arc over a chord that changes with the numbers given.
   *
   * @param which the two sides of the pixel that the chord ends at, as in {@link Sides#number}
   * @param x where it does, in the pixel
   */
  Arc(CornerGrid corners, Brackets brackets, int[] which, double[] x, double[] y) {
    this.corners = corners;
    this.brackets = brackets;
    this.which = which;
    this.x = x;
    this.y = y;
  }

  /** Measures the chord that is given now. */
  void measure() {
    dx = x[1] - x[0];
    dy = y[1] - y[0];
    squared = dx * dx + dy * dy;
    length = Math.sqrt(squared);
  }

  /**
   * Finds how the edge curves from what it does in the two neighbours: like a circle, which covers
   * L³κ/12 more than its chord of length L, if both turn the same way.
   *
   * @param orientation twice the signed area of the triangle of the chord and the upper left corner
   */
  void look(int column, int row, double orientation) {
    cornerLeft = orientation > 0;
    double one = curvature(column, row, 0);
    double two = curvature(column, row, 1);
    double unit = length * length * length / 12;
    double common = one * two > 0 ? Math.copySign(Math.min(Math.abs(one), Math.abs(two)), one) : 0;
    bulge = unit * (cornerLeft ? common : -common);
    doubt = unit * Math.max(Math.abs(one - common), Math.abs(two - common)) / 2;
    doubt += isInside(bulge) ? 0 : Math.abs(bulge);
  }

  /**
   * Takes the edge for an arc of a bulge, or for straight and doubtful if that is not surely in the
   * pixel.
   */
  void freeze(double known, double orientation) {
    cornerLeft = orientation > 0;
    bulge = isInside(known) ? known : 0;
    doubt = Math.abs(known - bulge);
  }

  /** Returns the length of the chord. */
  double length() {
    return length;
  }

  /**
   * Returns by how much a curved edge covers more than its chord, on the side of the upper left
   * corner.
   */
  double bulge() {
    return bulge;
  }

  /** Returns the uncertainty of that. */
  double doubt() {
    return doubt;
  }

  /** Returns by how much the edge turns to the left per length where it leaves the pixel, or 0. */
  private double curvature(int column, int row, int end) {
    int nextX = column + (which[end] == 3 ? 1 : 0) - (which[end] == 2 ? 1 : 0);
    int nextY = row + (which[end] == 1 ? 1 : 0) - (which[end] == 0 ? 1 : 0);
    if (nextX < 0 || nextY < 0 || nextX >= corners.stride - 1 || nextY >= corners.rows - 1) {
      return 0;
    }
    int here = which[end] ^ 1; // the same side, seen from the neighbour
    int others = corners.crossed(nextX, nextY) & ~(1 << here);
    if (Integer.bitCount(others) != 1) {
      return 0;
    }
    int other = Integer.numberOfTrailingZeros(others);
    int number = brackets.sides.number(nextX, nextY, other);
    if (brackets.steps(number) == Brackets.MIXED) {
      return 0;
    }
    double along = brackets.middle(number);
    double px = nextX - column + (other < 2 ? along : other - 2);
    double py = nextY - row + (other < 2 ? other : along);
    return turn(end, px, py);
  }

  /** Returns by how much the edge turns to the left per length on the way to where it goes on. */
  private double turn(int end, double px, double py) {
    double ex = end == 1 ? px - x[1] : x[0] - px;
    double ey = end == 1 ? py - y[1] : y[0] - py;
    double e = Math.sqrt(ex * ex + ey * ey);
    double turn = end == 1 ? dx * ey - dy * ex : ex * dy - ey * dx;
    return length > 0 && e > 0 ? 2 * turn / (length * e * (length + e)) : 0;
  }

  /**
   * Returns whether the parabola that covers so much more than its chord surely stays in the pixel:
   * it does if its control point is in it, which is twice as far from the chord.
   */
  private boolean isInside(double bulge) {
    double away = 3 * (cornerLeft ? -bulge : bulge) / squared;
    double controlX = 0.5 * (x[0] + x[1]) - away * dy;
    double controlY = 0.5 * (y[0] + y[1]) + away * dx;
    return controlX >= 0 && controlX <= 1 && controlY >= 0 && controlY <= 1;
  }

  /** Returns how far to the side the arc lies beside a place, as a parabola of the same bulge. */
  double beside(double u, double v) {
    double along = ((u - x[0]) * dx + (v - y[0]) * dy) / squared;
    double height = along > 0 && along < 1 ? 6 * bulge * along * (1 - along) : 0;
    return cornerLeft ? -height : height;
  }
}
