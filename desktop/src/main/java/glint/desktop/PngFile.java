package glint.desktop;

import glint.color.Transfer;
import glint.image.Image;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.FileImageOutputStream;

/** Writes PNG files with a record of their making. */
final class PngFile {

  /** The keyword of the text chunk that holds the record. */
  static final String KEYWORD = "glint";

  private static final String CHUNKS = "javax_imageio_png_1.0";

  private PngFile() {}

  /**
   * Writes an image as opaque 8-bit RGB, marked as sRGB unless its codes are linear.
   *
   * @param record a text in ASCII
   * @throws IOException if the file cannot be written
   */
  static void write(Image image, Transfer transfer, String record, Path path) throws IOException {
    BufferedImage pixels = packed(image.toArgb(transfer), image.width(), image.height());
    ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
    // Make the file first: unlike the stream below, this says why it cannot.
    Files.newOutputStream(path).close();
    try (FileImageOutputStream out = new FileImageOutputStream(path.toFile())) {
      writer.setOutput(out);
      ImageWriteParam defaults = writer.getDefaultWriteParam();
      IIOMetadata metadata =
          writer.getDefaultImageMetadata(
              ImageTypeSpecifier.createFromRenderedImage(pixels), defaults);
      metadata.mergeTree(CHUNKS, chunks(transfer, record));
      writer.write(null, new IIOImage(pixels, null, metadata), defaults);
    } finally {
      writer.dispose();
    }
  }

  private static BufferedImage packed(int[] argb, int width, int height) {
    int[] masks = {0xff0000, 0xff00, 0xff};
    WritableRaster raster =
        Raster.createPackedRaster(
            new DataBufferInt(argb, argb.length), width, height, width, masks, null);
    DirectColorModel colors = new DirectColorModel(24, masks[0], masks[1], masks[2]);
    return new BufferedImage(colors, raster, false, null);
  }

  private static IIOMetadataNode chunks(Transfer transfer, String record) {
    IIOMetadataNode entry = new IIOMetadataNode("tEXtEntry");
    entry.setAttribute("keyword", KEYWORD);
    entry.setAttribute("value", record);
    IIOMetadataNode text = new IIOMetadataNode("tEXt");
    text.appendChild(entry);
    IIOMetadataNode root = new IIOMetadataNode(CHUNKS);
    if (transfer == Transfer.SRGB) {
      IIOMetadataNode srgb = new IIOMetadataNode("sRGB");
      srgb.setAttribute("renderingIntent", "Perceptual");
      root.appendChild(srgb);
    }
    root.appendChild(text);
    return root;
  }
}
