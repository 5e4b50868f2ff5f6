package glint.render;

import glint.color.Transfer;
import glint.image.Image;

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
}
