package glint.optics;

import glint.color.Rgb;
import glint.math.Transform;

/** What a texture shows at a point, and where in its image that is; scratch. */
public final class Texel {

  /** The colour, linear. */
  public double r;

  public double g;
  public double b;

  /** Whether that is of an image, and not one of the colours of a pattern. */
  public boolean isOfImage;

  /** A number of the pattern's cell. */
  public long cell;

  /**
   * Where the point lies on the image: 0 to 1 from left to right and from the bottom to the top.
   */
  public double u;

  public double v;

  /** The same in pixels of the image, those of its repetitions counted on. */
  public double x;

  public double y;

  /** Scratch: the numbers of a transform. */
  public final double[] numbers = new double[Transform.NUMBERS];

  /** Shows the colour of a pattern's cell. */
  public void set(Rgb color, long number) {
    set(color);
    cell = number;
  }

  /** Shows a colour. */
  public void set(Rgb color) {
    r = color.r();
    g = color.g();
    b = color.b();
    isOfImage = false;
  }

  /** Returns the colour. */
  public Rgb color() {
    return new Rgb(r, g, b);
  }
}
