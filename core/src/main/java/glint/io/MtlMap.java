package glint.io;

import glint.image.ByteImage;
import glint.math.Check;
import glint.optics.ImageTexture;
import glint.optics.Layout;
import java.util.Optional;

/**
 * An image that an MTL file names, and how it is laid on; immutable.
 *
 * @param file as it is written, backslashes being slashes
 * @param line where it stands, from 1
 * @param column from 1
 * @param layout {@code -s}, {@code -o} and {@code -clamp}
 * @param base {@code -mm}: added to the image's values after the gain
 * @param gain {@code -mm}: what they are multiplied by
 */
public record MtlMap(String file, int line, int column, Layout layout, double base, double gain) {

  private static final double LARGEST = 1e6;

  /** Checks the numbers. */
  public MtlMap {
    Check.range("-mm", base, -LARGEST, LARGEST);
    Check.range("-mm", gain, -LARGEST, LARGEST);
  }

  /** Returns the texture that this makes of the image, which lies by the model's own points. */
  ImageTexture texture(ByteImage image) {
    return new ImageTexture(image, layout, Optional.empty(), base, gain);
  }
}
