package glint.desktop;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.WritableRaster;

/**
 * The samples of a decoded image as they stand in its file, row by row: getRGB would bend grey ones
 * through a colour profile.
 */
final class Samples {

  private final WritableRaster raster;

  /** Null unless the image has one. */
  private final IndexColorModel palette;

  private final int bands;
  private final int white;
  private final int[] row;

  Samples(BufferedImage image) {
    raster = image.getRaster();
    palette = image.getColorModel() instanceof IndexColorModel m ? m : null;
    bands = raster.getNumBands();
    white = palette != null ? 255 : (1 << raster.getSampleModel().getSampleSize(0)) - 1;
    row = new int[bands * image.getWidth()];
  }

  /** Returns the sample that is white: 255 for eight bits. */
  int white() {
    return white;
  }

  /** Goes to a row. */
  void row(int y) {
    raster.getPixels(0, y, raster.getWidth(), 1, row);
  }

  /** Returns the sample of a channel, 0 to 2, in a column of the row; grey has the same in all. */
  int of(int x, int channel) {
    int at = bands * x;
    if (palette == null) {
      return row[at + (bands >= 3 ? channel : 0)];
    }
    return switch (channel) {
      case 0 -> palette.getRed(row[at]);
      case 1 -> palette.getGreen(row[at]);
      default -> palette.getBlue(row[at]);
    };
  }

  /** Returns whether a column of the row lets through what lies behind. */
  boolean isTransparent(int x) {
    int at = bands * x;
    if (palette != null) {
      return palette.getAlpha(row[at]) < 255;
    }
    return bands % 2 == 0 && row[at + bands - 1] < white;
  }
}
