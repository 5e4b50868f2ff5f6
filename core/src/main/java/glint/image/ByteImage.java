package glint.image;

/**
 * A picture of eight-bit sRGB codes, as image files hold it; its array is never changed once it is
 * made.
 */
public final class ByteImage {

  /** The most pixels of one: 192 MiB. */
  public static final int MAX_PIXELS = 1 << 26;

  private final int width;
  private final int height;
  private final byte[] rgb;
  private final int[] most = new int[3];

  /**
   * Takes over the array: nobody may change it any more.
   *
   * @param rgb red, green and blue of every pixel, row by row from the top
   * @throws IllegalArgumentException if there are no or too many pixels, or another number of codes
   */
  public ByteImage(int width, int height, byte[] rgb) {
    checkSize(width, height);
    if (rgb.length != 3 * width * height) {
      throw new IllegalArgumentException("every pixel needs three codes");
    }
    this.width = width;
    this.height = height;
    this.rgb = rgb;
    for (int i = 0; i < rgb.length; i++) {
      most[i % 3] = Math.max(most[i % 3], rgb[i] & 0xff);
    }
  }

  /** Returns a picture of one pixel. */
  public static ByteImage of(int r, int g, int b) {
    return new ByteImage(1, 1, new byte[] {(byte) r, (byte) g, (byte) b});
  }

  /**
   * Checks the size of a picture that is about to be made.
   *
   * @throws IllegalArgumentException if it is no size, or has more than {@link #MAX_PIXELS}
   */
  public static void checkSize(int width, int height) {
    if (width < 1 || height < 1 || (long) width * height > MAX_PIXELS) {
      throw new IllegalArgumentException(
          "it has " + width + "x" + height + " pixels; up to " + MAX_PIXELS + " are read");
    }
  }

  /** Returns the number of columns. */
  public int width() {
    return width;
  }

  /** Returns the number of rows. */
  public int height() {
    return height;
  }

  /** Returns the number of the first code of the pixel in a column and a row. */
  public int at(int x, int y) {
    return 3 * (y * width + x);
  }

  /** Returns a code, 0 to 255, by its number. */
  public int code(int number) {
    return rgb[number] & 0xff;
  }

  /** Returns the code, 0 to 255, of a channel, 0 to 2, of the pixel in a column and a row. */
  public int code(int x, int y, int channel) {
    return rgb[3 * (y * width + x) + channel] & 0xff;
  }

  /** Returns the highest code of a channel. */
  public int most(int channel) {
    return most[channel];
  }
}
