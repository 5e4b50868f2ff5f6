package glint.render;

import java.util.Arrays;

/** The mean colours of the two parts that an edge divides a pixel in; scratch. */
final class Parts {

  /** Which way each corner of the pixel lies, clockwise from the upper left one. */
  private static final int[] X = {0, 1, 1, 0};

  private static final int[] Y = {0, 0, 1, 1};

  /** The side from each corner to the next: 0 top, 1 bottom, 2 left, 3 right. */
  private static final int[] SIDE = {0, 3, 1, 2};

  /** Less of a pixel has no colour of its own. */
  private static final double LEAST_AREA = 1e-9;

  /** A place in the pixel and the radiance there. */
  private static final int POINT = 5;

  private final CornerGrid corners;
  private final Brackets brackets;

  /** The corners of the pixel at hand, clockwise. */
  private final int[] corner = new int[4];

  /** The part that each belongs to. */
  private final int[] part = new int[4];

  /** The points of both outlines, clockwise: every corner, and either side of each crossing. */
  private final double[] points = new double[8 * POINT];

  /** Of either part: the first and the last point of its outline, or -1. */
  private final int[] start = new int[2];

  private final int[] last = new int[2];
  private final double[] area = new double[2];
  private final double[][] sum = new double[2][3];

  /** The colour on the side of the upper left corner, and that on the other. */
  final double[] first = new double[3];

  final double[] second = new double[3];

  Parts(CornerGrid corners, Brackets brackets) {
    this.corners = corners;
    this.brackets = brackets;
  }

  /** Takes each part for as bright all over as its corners are. */
  void fromCorners(int column, int row) {
    turn(column, row);
    plain(first, 0);
    plain(second, 1);
  }

  /**
   * Takes the radiance to run evenly, over triangles, between a part's corners and what the search
   * for the edge has seen beside it.
   *
   * @param which the sides of the pixel that the edge crosses
   * @param x where it does, in the pixel
   */
  void fromSearch(int column, int row, int[] which, double[] x, double[] y) {
    turn(column, row);
    Arrays.fill(start, -1);
    Arrays.fill(area, 0);
    Arrays.fill(sum[0], 0);
    Arrays.fill(sum[1], 0);
    int at = 0;
    for (int i = 0; i < 4; i++) {
      System.arraycopy(corners.rgb, 3 * corner[i], points, at + 2, 3);
      at = add(part[i], at, X[i], Y[i]);
      int crossing = which[0] == SIDE[i] ? 0 : which[1] == SIDE[i] ? 1 : -1;
      if (crossing >= 0) {
        int next = (i + 1) % 4;
        int side = brackets.sides.number(column, row, SIDE[i]);
        boolean forward = i < 2;
        brackets.beside(side, !forward, corner[i], points, at + 2);
        at = add(part[i], at, x[crossing], y[crossing]);
        brackets.beside(side, forward, corner[next], points, at + 2);
        at = add(part[next], at, x[crossing], y[crossing]);
      }
    }
    finish(first, 0);
    finish(second, 1);
  }

  private void turn(int column, int row) {
    corner[0] = row * corners.stride + column;
    corner[1] = corner[0] + 1;
    corner[2] = corner[1] + corners.stride;
    corner[3] = corner[0] + corners.stride;
    for (int i = 0; i < 4; i++) {
      part[i] = corners.signature[corner[i]] == corners.signature[corner[0]] ? 0 : 1;
    }
  }

  /**
   * Adds a point to the outline of a part, and the triangle that it completes.
   *
   * @param at where its radiance stands among the points
   * @return where the next may stand
   */
  private int add(int part, int at, double x, double y) {
    points[at] = x;
    points[at + 1] = y;
    int a = start[part];
    int b = last[part];
    if (a < 0) {
      start[part] = at;
    } else if (a != b) {
      double twice =
          (points[b] - points[a]) * (y - points[a + 1])
              - (points[b + 1] - points[a + 1]) * (x - points[a]);
      area[part] += twice;
      for (int i = 2; i < POINT; i++) {
        sum[part][i - 2] += twice / 3 * (points[a + i] + points[b + i] + points[at + i]);
      }
    }
    last[part] = at;
    return at + POINT;
  }

  private void finish(double[] colour, int part) {
    if (!(area[part] > LEAST_AREA)) {
      plain(colour, part);
      return;
    }
    for (int i = 0; i < 3; i++) {
      colour[i] = sum[part][i] / area[part];
    }
  }

  private void plain(double[] colour, int which) {
    Arrays.fill(colour, 0);
    int count = 0;
    for (int i = 0; i < 4; i++) {
      if (part[i] == which) {
        count++;
        for (int channel = 0; channel < 3; channel++) {
          colour[channel] += corners.rgb[3 * corner[i] + channel];
        }
      }
    }
    for (int channel = 0; channel < 3; channel++) {
      colour[channel] /= count;
    }
  }
}
