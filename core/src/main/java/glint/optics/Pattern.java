package glint.optics;

import glint.color.Rgb;

/**
 * A texture of two colours in turn; immutable.
 *
 * <p>It lives in the space of the surface that wears it. On curved surfaces it is solid: cut out of
 * a patterned block. On flat parts the axis nearest to their normal is left out, or rounding would
 * decide what a face shows that lies between two cells.
 */
public sealed interface Pattern extends Texture permits Checker, Stripes {

  /** In place of an axis: none is left out. */
  int SOLID = -1;

  /**
   * Returns the colour at a point of the surface's own space.
   *
   * @param flat the axis to leave out, 0 to 2, or {@link #SOLID}
   */
  Rgb at(double x, double y, double z, int flat);

  /** Returns a number of the cell that a point lies in: others nearby have others. */
  long cell(double x, double y, double z, int flat);

  /** Returns whether a coordinate lies in a cell of an odd number. */
  static boolean isOdd(double coordinate, double size) {
    double half = 0.5 * index(coordinate, size);
    return half != Math.floor(half);
  }

  /** Returns the number of the cell that a coordinate lies in. */
  static double index(double coordinate, double size) {
    return Math.floor(coordinate / size);
  }

  /** Returns the larger of two colours, channel by channel. */
  static Rgb most(Rgb a, Rgb b) {
    return new Rgb(Math.max(a.r(), b.r()), Math.max(a.g(), b.g()), Math.max(a.b(), b.b()));
  }
}
