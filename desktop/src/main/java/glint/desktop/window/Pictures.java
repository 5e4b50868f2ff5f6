package glint.desktop.window;

import glint.color.Transfer;
import glint.image.Image;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

/** Makes pictures for the display; any thread may. */
final class Pictures {

  private Pictures() {}

  /** Returns the picture of colours, row by row. */
  static BufferedImage of(int[] codes, int width, int height) {
    BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    picture.getRaster().setDataElements(0, 0, width, height, codes);
    return picture;
  }

  /** Returns the picture of an image in linear light. */
  static BufferedImage of(Image image, Transfer transfer) {
    return of(image.toArgb(transfer), image.width(), image.height());
  }

  /** Returns the picture of every n-th column and row of an image in linear light. */
  static BufferedImage everyNth(Image image, int n, Transfer transfer) {
    Image few = new Image((image.width() - 1) / n + 1, (image.height() - 1) / n + 1);
    double[] rgb = image.rgb();
    for (int y = 0; y < few.height(); y++) {
      for (int x = 0; x < few.width(); x++) {
        int at = 3 * n * (y * image.width() + x);
        few.set(x, y, rgb[at], rgb[at + 1], rgb[at + 2]);
      }
    }
    return of(few, transfer);
  }

  /** Returns the left part of one picture beside the right part of another of the same size. */
  static BufferedImage beside(BufferedImage left, BufferedImage right, double part) {
    int width = left.getWidth();
    int height = left.getHeight();
    int x = (int) Math.rint(part * width);
    BufferedImage both = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = both.createGraphics();
    g.drawImage(right, 0, 0, null);
    g.drawImage(left, 0, 0, x, height, 0, 0, x, height, null);
    if (x > 0 && x < width) {
      g.setColor(Color.WHITE);
      g.fillRect(x, 0, 1, height);
    }
    g.dispose();
    return both;
  }
}
