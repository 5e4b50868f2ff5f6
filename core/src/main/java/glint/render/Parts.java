package glint.render;

import java.util.Arrays;

/** The mean colours of the two parts that an edge divides a pixel in; scratch. */
final class Parts {

  /** Which way each corner of the pixel lies, clockwise from the upper left one. */
  private static final int[] X = {0, 1, 1, 0};

  private static final int[] Y = {0, 0, 1, 1};

  /** The side from each corner to the next: 0 top, 1 bottom, 2 left, 3 right. */
  private static final int[] SIDE = {0, 3, 1, 2};

  /** The corner where each side begins, clockwise. */
  private static final int[] BEGIN = {0, 2, 3, 1};

  /** Less of a pixel has no colour of its own. */
  private static final double LEAST_AREA = 1e-9;

  /**
   * The outlines of both parts, by the sum of two to the power of each side that is crossed:
   * numbers of points, clockwise. The corners are 0 to 3; 4 and 5 lie beside the crossing of the
   * first side, 6 and 7 of the second, as they come.
   */
  private static final int[][][] OUTLINES = new int[16][][];

  static {
    for (int one = 0; one < 4; one++) {
      for (int two = one + 1; two < 4; two++) {
        OUTLINES[1 << one | 1 << two] = outlines(one, two);
      }
    }
  }

  /** A place in the pixel and the radiance there. */
  private static final int POINT = 5;

  private final CornerGrid corners;
  private final Brackets brackets;

  /** The corners of the pixel at hand, clockwise. */
  private final int[] corner = new int[4];

  private final double[] points = new double[8 * POINT];

  /** The colour on the side of the upper left corner, and that on the other. */
  final double[] first = new double[3];

  final double[] second = new double[3];

  Parts(CornerGrid corners, Brackets brackets) {
    this.corners = corners;
    this.brackets = brackets;
  }

  private static int[][] outlines(int one, int two) {
    int[][] outlines = {{}, {}};
    int part = 0;
    for (int i = 0; i < 4; i++) {
      outlines[part] = append(outlines[part], i);
      if (SIDE[i] == one || SIDE[i] == two) {
        int beside = SIDE[i] == one ? 4 : 6;
        outlines[part] = append(outlines[part], beside);
        part = 1 - part;
        outlines[part] = append(outlines[part], beside + 1);
      }
    }
    return outlines;
  }

  private static int[] append(int[] numbers, int number) {
    int[] more = Arrays.copyOf(numbers, numbers.length + 1);
    more[numbers.length] = number;
    return more;
  }

  /**
   * Takes each part for as bright all over as its corners are.
   *
   * @param which the two sides of the pixel that the edge crosses
   */
  void fromCorners(int column, int row, int[] which) {
    turn(column, row);
    int[][] outlines = OUTLINES[1 << which[0] | 1 << which[1]];
    plain(outlines[0], first);
    plain(outlines[1], second);
  }

  /**
   * Takes the radiance to run evenly, over triangles, between a part's corners and what the search
   * for the edge has seen beside it.
   *
   * @param which the two sides of the pixel that the edge crosses
   * @param x where it does, in the pixel
   */
  void fromSearch(int column, int row, int[] which, double[] x, double[] y) {
    turn(column, row);
    for (int i = 0; i < 4; i++) {
      set(i, X[i], Y[i]);
      for (int channel = 0; channel < 3; channel++) {
        points[POINT * i + 2 + channel] = corners.rgb[3 * corner[i] + channel];
      }
    }
    for (int i = 0; i < 2; i++) {
      // Clockwise, the bottom and the left side begin where they end by number.
      boolean backward = which[i] == 1 || which[i] == 2;
      int side = brackets.sides.number(column, row, which[i]);
      int beside = 4 + 2 * i;
      set(beside, x[i], y[i]);
      set(beside + 1, x[i], y[i]);
      int begin = BEGIN[which[i]];
      brackets.beside(side, backward, corner[begin], points, POINT * beside + 2);
      brackets.beside(side, !backward, corner[(begin + 1) % 4], points, POINT * beside + POINT + 2);
    }
    int[][] outlines = OUTLINES[1 << which[0] | 1 << which[1]];
    fill(outlines[0], first);
    fill(outlines[1], second);
  }

  private void turn(int column, int row) {
    corner[0] = row * corners.stride + column;
    corner[1] = corner[0] + 1;
    corner[2] = corner[1] + corners.stride;
    corner[3] = corner[0] + corners.stride;
  }

  private void set(int point, double x, double y) {
    points[POINT * point] = x;
    points[POINT * point + 1] = y;
  }

  /**
   * Finds the mean over the triangles between the first point of an outline and every two others.
   */
  private void fill(int[] outline, double[] colour) {
    int a = POINT * outline[0];
    int b = POINT * outline[1];
    double area = 0;
    double red = 0;
    double green = 0;
    double blue = 0;
    for (int i = 2; i < outline.length; i++) {
      int c = POINT * outline[i];
      double twice =
          (points[b] - points[a]) * (points[c + 1] - points[a + 1])
              - (points[b + 1] - points[a + 1]) * (points[c] - points[a]);
      double third = twice / 3;
      area += twice;
      red += third * (points[a + 2] + points[b + 2] + points[c + 2]);
      green += third * (points[a + 3] + points[b + 3] + points[c + 3]);
      blue += third * (points[a + 4] + points[b + 4] + points[c + 4]);
      b = c;
    }
    if (area > LEAST_AREA) {
      colour[0] = red / area;
      colour[1] = green / area;
      colour[2] = blue / area;
    } else {
      plain(outline, colour);
    }
  }

  private void plain(int[] outline, double[] colour) {
    Arrays.fill(colour, 0);
    int count = 0;
    for (int point : outline) {
      if (point < 4) {
        count++;
        for (int channel = 0; channel < 3; channel++) {
          colour[channel] += corners.rgb[3 * corner[point] + channel];
        }
      }
    }
    for (int channel = 0; channel < 3; channel++) {
      colour[channel] /= count;
    }
  }
}
