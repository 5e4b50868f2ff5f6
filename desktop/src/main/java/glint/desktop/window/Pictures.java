package glint.desktop.window;

import glint.color.Transfer;
import glint.image.Image;
import java.awt.image.BufferedImage;

/** Makes pictures for the display. */
final class Pictures {

  private Pictures() {}

  /** Returns what an image looks like by an output curve, as its PNG does. */
  static BufferedImage of(Image image, Transfer transfer) {
    int width = image.width();
    BufferedImage picture = new BufferedImage(width, image.height(), BufferedImage.TYPE_INT_RGB);
    int[] codes = image.toArgb(transfer);
    picture.getRaster().setDataElements(0, 0, width, image.height(), codes);
    return picture;
  }
}
