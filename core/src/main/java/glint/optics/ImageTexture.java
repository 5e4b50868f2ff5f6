package glint.optics;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.image.ByteImage;
import java.util.Optional;

/**
 * An image laid on surfaces; immutable.
 *
 * <p>Between the centres of its pixels colours are interpolated, in linear light: what a picture of
 * it shows is the mean of light, not of codes.
 */
public final class ImageTexture implements Texture {

  private final ByteImage image;
  private final Layout layout;
  private final Optional<Mapping> mapping;

  /** The linear value of every code. */
  private final double[] linear = new double[256];

  /** Makes a texture of an image as it is. */
  public ImageTexture(ByteImage image, Layout layout, Optional<Mapping> mapping) {
    this(image, layout, mapping, 0, 1);
  }

  /**
   * Makes a texture.
   *
   * @param mapping how it lies in the space of surfaces; if absent, every kind has its own way
   * @param base added to linear values after the gain; the sum is at least 0
   * @param gain what they are multiplied by
   */
  public ImageTexture(
      ByteImage image, Layout layout, Optional<Mapping> mapping, double base, double gain) {
    this.image = image;
    this.layout = layout;
    this.mapping = mapping;
    for (int code = 0; code < linear.length; code++) {
      linear[code] = Math.max(0, base + gain * Transfer.SRGB.decode(code / 255.0));
    }
  }

  /** Returns the image. */
  public ByteImage image() {
    return image;
  }

  /** Returns how often it lies there. */
  public Layout layout() {
    return layout;
  }

  /** Returns how it lies in the space of surfaces, unless that is their own way. */
  public Optional<Mapping> mapping() {
    return mapping;
  }

  /** Sets a texel to the colour at its u and v, and to where in the image that is. */
  public void at(Texel texel) {
    texel.isOfImage = true;
    double placeU = layout.placeU(texel.u);
    double placeV = layout.placeV(texel.v);
    texel.x = placeU * image.width();
    texel.y = placeV * image.height();
    // Find the four pixels around; the rows of an image begin at the top.
    double x = layout.wrap().within(placeU) * image.width() - 0.5;
    double y = (1 - layout.wrap().within(placeV)) * image.height() - 0.5;
    double x0 = Math.floor(x);
    double y0 = Math.floor(y);
    int left = index((int) x0, image.width());
    int right = index((int) x0 + 1, image.width());
    int upper = index((int) y0, image.height());
    int lower = index((int) y0 + 1, image.height());
    double toRight = x - x0;
    double down = y - y0;
    texel.r = between(left, right, upper, lower, toRight, down, 0);
    texel.g = between(left, right, upper, lower, toRight, down, 1);
    texel.b = between(left, right, upper, lower, toRight, down, 2);
  }

  /**
   * Returns the number, 0 to {@code count - 1}, of the pixel that is shown in place of -1 to it.
   */
  private int index(int i, int count) {
    if (i < 0) {
      return layout.wrap() == Wrap.REPEAT ? count - 1 : 0;
    }
    if (i >= count) {
      return layout.wrap() == Wrap.REPEAT ? 0 : count - 1;
    }
    return i;
  }

  private double between(
      int left, int right, int upper, int lower, double toRight, double down, int channel) {
    double a = linear[image.code(left, upper, channel)];
    double b = linear[image.code(right, upper, channel)];
    double c = linear[image.code(left, lower, channel)];
    double d = linear[image.code(right, lower, channel)];
    double above = a + toRight * (b - a);
    return above + down * (c + toRight * (d - c) - above);
  }

  @Override
  public Rgb most() {
    return new Rgb(most(0), most(1), most(2));
  }

  /** Values rise with codes, or with a negative gain fall. */
  private double most(int channel) {
    return Math.max(linear[0], linear[image.most(channel)]);
  }
}
