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

  private final CornerGrid corners;
  private final Sides sides;

  /** The corners of the pixel at hand, clockwise. */
  private final int[] corner = new int[4];

  /** Of either part: the first and the last point of its outline, a colour beside each. */
  private final double[][] start = new double[2][5];

  private final double[][] last = new double[2][5];
  private final int[] points = new int[2];
  private final double[] area = new double[2];
  private final double[][] sum = new double[2][3];
  private final double[] point = new double[5];

  /** The colour on the side of the upper left corner, and that on the other. */
  final double[] first = new double[3];

  final double[] second = new double[3];

  Parts(CornerGrid corners, Sides sides) {
    this.corners = corners;
    this.sides = sides;
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
    Arrays.fill(points, 0);
    Arrays.fill(area, 0);
    Arrays.fill(sum[0], 0);
    Arrays.fill(sum[1], 0);
    for (int i = 0; i < 4; i++) {
      point[0] = X[i];
      point[1] = Y[i];
      System.arraycopy(corners.rgb, 3 * corner[i], point, 2, 3);
      add(part(i));
      int crossing = which[0] == SIDE[i] ? 0 : which[1] == SIDE[i] ? 1 : -1;
      if (crossing >= 0) {
        point[0] = x[crossing];
        point[1] = y[crossing];
        int side = sides.number(column, row, SIDE[i]);
        boolean forward = i < 2;
        sides.beside(side, !forward, point);
        add(part(i));
        sides.beside(side, forward, point);
        add(part((i + 1) % 4));
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
  }

  private int part(int i) {
    return corners.signature[corner[i]] == corners.signature[corner[0]] ? 0 : 1;
  }

  /** Adds {@link #point} to the outline of a part, and the triangle that it completes. */
  private void add(int part) {
    double[] a = start[part];
    double[] b = last[part];
    if (points[part] == 0) {
      System.arraycopy(point, 0, a, 0, 5);
    } else if (points[part] > 1) {
      double twice = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
      area[part] += twice;
      for (int i = 0; i < 3; i++) {
        sum[part][i] += twice / 3 * (a[2 + i] + b[2 + i] + point[2 + i]);
      }
    }
    System.arraycopy(point, 0, b, 0, 5);
    points[part]++;
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

  private void plain(double[] colour, int part) {
    Arrays.fill(colour, 0);
    int count = 0;
    for (int i = 0; i < 4; i++) {
      if (part(i) == part) {
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
