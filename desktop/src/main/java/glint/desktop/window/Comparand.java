package glint.desktop.window;

import glint.color.Transfer;
import glint.image.Image;
import java.awt.image.BufferedImage;
import java.nio.file.Path;

/**
 * An image that a render is compared with; immutable.
 *
 * @param picture the image for the display
 */
record Comparand(Path file, Image image, Transfer transfer, BufferedImage picture) {

  /** Makes one of what a file holds. */
  static Comparand of(Path file, Image image, Transfer transfer) {
    return new Comparand(file, image, transfer, Pictures.of(image, transfer));
  }
}
