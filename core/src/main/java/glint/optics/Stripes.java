package glint.optics;

import glint.color.Rgb;
import glint.math.Check;

/**
 * Layers of two colours in turn, square to z, or to y on flat parts that face along z; immutable.
 *
 * @param size the width of a stripe in scene units; stripes begin at the origin
 * @param a the colour of the stripe that begins there
 * @param b the colour of its neighbours
 */
public record Stripes(double size, Rgb a, Rgb b) implements Pattern {

  /** Checks size and colours. */
  public Stripes {
    Check.positive("size", size);
    a.requireLight("colors");
    b.requireLight("colors");
  }

  @Override
  public Rgb at(double x, double y, double z, int flat) {
    return Pattern.isOdd(flat == 2 ? y : z, size) ? b : a;
  }

  @Override
  public long cell(double x, double y, double z, int flat) {
    return (long) Pattern.index(flat == 2 ? y : z, size);
  }

  @Override
  public Rgb most() {
    return Pattern.most(a, b);
  }
}
