package glint.image;

import glint.color.Transfer;
import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;

/**
 * A picture in linear light: {@code width × height} RGB doubles, row by row from the top.
 *
 * <p>Not immutable: the pixel array is owned by whoever made the image.
 */
public final class Image {

  private final int width;
  private final int height;
  private final double[] rgb;

  /**
   * Makes a black image.
   *
   * @throws IllegalArgumentException if a side is below 1 or the pixels do not fit an array
   */
  public Image(int width, int height) {
    if (width < 1 || height < 1 || (long) width * height > (Integer.MAX_VALUE - 8) / 3) {
      throw new IllegalArgumentException("cannot hold an image of " + width + "x" + height);
    }
    this.width = width;
    this.height = height;
    this.rgb = new double[3 * width * height];
  }

  /** Returns the number of columns. */
  public int width() {
    return width;
  }

  /** Returns the number of rows. */
  public int height() {
    return height;
  }

  /**
   * Returns the linear values, not a copy: red, green, blue of the pixel in column x and row y
   * (from the top) stand at {@code 3 * (y * width + x)}.
   */
  public double[] rgb() {
    return rgb;
  }

  /** Sets the pixel in column {@code x} and row {@code y}. */
  public void set(int x, int y, double r, double g, double b) {
    int at = 3 * (y * width + x);
    rgb[at] = r;
    rgb[at + 1] = g;
    rgb[at + 2] = b;
  }

  /** Returns the opaque ARGB codes of all pixels under a transfer curve, row by row. */
  public int[] toArgb(Transfer transfer) {
    int[] argb = new int[width * height];
    for (int i = 0; i < argb.length; i++) {
      int r = transfer.code(rgb[3 * i]);
      int g = transfer.code(rgb[3 * i + 1]);
      int b = transfer.code(rgb[3 * i + 2]);
      argb[i] = 0xff000000 | r << 16 | g << 8 | b;
    }
    return argb;
  }

  /** Returns the SHA-256 of the linear values as doubles, big-endian, in row order, in hex. */
  public String sha256() {
    MessageDigest digest;
    try {
      digest = MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
    int row = 3 * width;
    ByteBuffer bytes = ByteBuffer.allocate(8 * row);
    for (int y = 0; y < height; y++) {
      bytes.asDoubleBuffer().put(rgb, y * row, row);
      digest.update(bytes.array());
    }
    StringBuilder hex = new StringBuilder();
    for (byte b : digest.digest()) {
      hex.append(Character.forDigit(b >> 4 & 15, 16)).append(Character.forDigit(b & 15, 16));
    }
    return hex.toString();
  }
}
