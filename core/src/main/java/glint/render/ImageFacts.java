package glint.render;

import glint.color.Transfer;
import glint.image.Image;
import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;

/** Figures of a finished image that need every pixel. */
final class ImageFacts {

  /** A rise, in levels, up to which the slope of a curve bounds it well. */
  private static final double LITTLE = 0.1;

  private ImageFacts() {}

  /** Returns the number of pixels with a channel above display white. */
  static long clipped(Image image) {
    double[] rgb = image.rgb();
    long clipped = 0;
    for (int i = 0; i < rgb.length; i += 3) {
      if (rgb[i] > 1 || rgb[i + 1] > 1 || rgb[i + 2] > 1) {
        clipped++;
      }
    }
    return clipped;
  }

  /**
   * Returns a bound on the RMS error, over all pixels and channels and in display levels, of light
   * that is missing.
   *
   * @param cut how much at most, for every pixel; where it is infinite the display's range bounds
   *     it
   */
  static double truncation(Image image, double[] cut, Transfer transfer) {
    LevelScale scale = LevelScale.of(transfer);
    double[] rgb = image.rgb();
    double sum = 0;
    for (int i = 0; i < rgb.length; i++) {
      if (cut[i / 3] > 0) {
        double error = scale.rise(rgb[i], cut[i / 3]);
        if (!(error < LITTLE)) {
          error = transfer.level(rgb[i] + cut[i / 3]) - transfer.level(rgb[i]);
        }
        sum += error * error;
      }
    }
    return Math.sqrt(sum / rgb.length);
  }

  /** Returns the SHA-256 of the image's doubles, big-endian, in row order, in hex. */
  static String sha256(Image image) {
    MessageDigest digest;
    try {
      digest = MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
    int row = 3 * image.width();
    ByteBuffer bytes = ByteBuffer.allocate(8 * row);
    for (int y = 0; y < image.height(); y++) {
      bytes.asDoubleBuffer().put(image.rgb(), y * row, row);
      digest.update(bytes.array());
    }
    StringBuilder hex = new StringBuilder();
    for (byte b : digest.digest()) {
      hex.append(Character.forDigit(b >> 4 & 15, 16)).append(Character.forDigit(b & 15, 16));
    }
    return hex.toString();
  }
}
