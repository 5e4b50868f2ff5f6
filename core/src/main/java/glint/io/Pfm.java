package glint.io;

import glint.image.Image;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * The portable float map: a short text header, then 32-bit floats, rows from bottom to top (pfm(5)
 * of Netpbm).
 *
 * <p>Values are linear light and may be negative, infinite or NaN.
 */
public final class Pfm {

  private static final int PIXELS_PER_BLOCK = 4096;

  private Pfm() {}

  /**
   * Writes an image as a colour map, little-endian, scale -1.0, each value as the nearest float;
   * what no float reaches becomes infinite.
   *
   * @throws IOException if the stream does not take it; the stream is neither flushed nor closed
   */
  public static void write(Image image, OutputStream out) throws IOException {
    int width = image.width();
    String header = "PF\n" + width + " " + image.height() + "\n-1.0\n";
    out.write(header.getBytes(StandardCharsets.US_ASCII));
    byte[] block = new byte[12 * PIXELS_PER_BLOCK];
    int filled = 0;
    for (int y = image.height() - 1; y >= 0; y--) {
      for (int i = 3 * width * y; i < 3 * width * (y + 1); i++) {
        int bits = Float.floatToIntBits((float) image.rgb()[i]);
        for (int shift = 0; shift < 32; shift += 8) {
          block[filled] = (byte) (bits >> shift);
          filled++;
        }
        if (filled == block.length) {
          out.write(block);
          filled = 0;
        }
      }
    }
    out.write(block, 0, filled);
  }

  /**
   * Reads a colour (PF) or grey (Pf) map of either byte order, up to the end of the stream.
   *
   * <p>A negative scale says little-endian. Its magnitude, which only tells the unit of the values,
   * is ignored. One white-space character ends the header, and nothing may follow the pixels. The
   * memory taken is in proportion to the bytes that are really there, whatever the header claims.
   *
   * @param name how error messages call the image
   * @throws IOException if the stream fails or is not exactly one such map: "name: not a PFM image:
   *     what is wrong"
   */
  public static Image read(InputStream in, String name) throws IOException {
    return new PfmReader(in, name).read();
  }
}
