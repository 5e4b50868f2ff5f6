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

  /** So many columns and rows of pixels tell the mean colour. */
  private static final int LOOKED_AT = 64;

  private final Rgb mean;

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
    mean = new Rgb(mean(0), mean(1), mean(2));
  }

  private double mean(int channel) {
    int right = (image.width() - 1) / LOOKED_AT + 1;
    int down = (image.height() - 1) / LOOKED_AT + 1;
    double sum = 0;
    int count = 0;
    for (int y = down / 2; y < image.height(); y += down) {
      for (int x = right / 2; x < image.width(); x += right) {
        sum += linear[image.code(x, y, channel)];
        count++;
      }
    }
    return sum / count;
  }

  /** Returns about the mean colour of the image. */
  public Rgb mean() {
    return mean;
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
    show(texel, placeU, placeV);
  }

  /** Sets a texel to the colour at its x and y. */
  public void atPlace(Texel texel) {
    show(texel, texel.x / image.width(), texel.y / image.height());
  }

  private void show(Texel texel, double placeU, double placeV) {
    // Find the four pixels around; the rows of an image begin at the top.
    double x = layout.wrap().within(placeU) * image.width() - 0.5;
    double y = (1 - layout.wrap().within(placeV)) * image.height() - 0.5;
    double x0 = Math.floor(x);
    double y0 = Math.floor(y);
    int left = index((int) x0, image.width());
    int right = index((int) x0 + 1, image.width());
    int upper = index((int) y0, image.height());
    int lower = index((int) y0 + 1, image.height());
    int a = image.at(left, upper);
    int b = image.at(right, upper);
    int c = image.at(left, lower);
    int d = image.at(right, lower);
    double toRight = x - x0;
    double down = y - y0;
    texel.r = between(a, b, c, d, toRight, down);
    texel.g = between(a + 1, b + 1, c + 1, d + 1, toRight, down);
    texel.b = between(a + 2, b + 2, c + 2, d + 2, toRight, down);
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

  private double between(int a, int b, int c, int d, double toRight, double down) {
    double upperLeft = linear[image.code(a)];
    double lowerLeft = linear[image.code(c)];
    double above = upperLeft + toRight * (linear[image.code(b)] - upperLeft);
    return above + down * (lowerLeft + toRight * (linear[image.code(d)] - lowerLeft) - above);
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
