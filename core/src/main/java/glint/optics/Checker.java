package glint.optics;

import glint.color.Rgb;
import glint.math.Check;

/**
 * Cubes, or on flat parts squares, of two colours in turn; immutable.
 *
 * @param size the edge of a cell in scene units; cells begin at the origin
 * @param a the colour of the cell at the origin, where all coordinates are positive
 * @param b the colour of its neighbours
 */
public record Checker(double size, Rgb a, Rgb b) implements Pattern {

  /** Checks size and colours. */
  public Checker {
    Check.positive("size", size);
    a.requireLight("colors");
    b.requireLight("colors");
  }

  @Override
  public Rgb at(double x, double y, double z, int flat) {
    boolean odd = flat != 0 && Pattern.isOdd(x, size);
    odd ^= flat != 1 && Pattern.isOdd(y, size);
    odd ^= flat != 2 && Pattern.isOdd(z, size);
    return odd ? b : a;
  }

  @Override
  public long cell(double x, double y, double z, int flat) {
    long i = flat == 0 ? 0 : (long) Pattern.index(x, size);
    long j = flat == 1 ? 0 : (long) Pattern.index(y, size);
    long k = flat == 2 ? 0 : (long) Pattern.index(z, size);
    return i + (j << 21) + (k << 42);
  }

  @Override
  public Rgb most() {
    return Pattern.most(a, b);
  }
}
