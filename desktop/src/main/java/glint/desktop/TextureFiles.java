package glint.desktop;

import glint.image.ByteImage;
import java.awt.image.BufferedImage;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Iterator;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Decodes PNG and JPEG images to eight-bit codes. */
final class TextureFiles {

  /** What decoding takes at most: three codes, and four samples of up to two bytes. */
  private static final long BYTES_PER_PIXEL = 3 + 8;

  private TextureFiles() {}

  /**
   * Decodes an image; the first bytes say of which kind it is.
   *
   * @param remarks is told what is left aside
   * @throws IOException if it is broken, too large, or of another kind
   */
  static ByteImage decode(InputStream in, Consumer<String> remarks) throws IOException {
    InputStream bytes = new BufferedInputStream(in, 1 << 16);
    bytes.mark(2);
    int first = bytes.read();
    int second = bytes.read();
    bytes.reset();
    boolean png = first == 0x89 && second == 'P';
    if (!png && !(first == 0xff && second == 0xd8)) {
      throw new IOException("neither a PNG nor a JPEG image");
    }
    ImageReader reader = ImageIO.getImageReadersByFormatName(png ? "png" : "jpeg").next();
    try (ImageInputStream stream = new MemoryCacheImageInputStream(bytes)) {
      reader.setInput(stream, true, true);
      checkSize(reader.getWidth(0), reader.getHeight(0));
      if (!png) {
        checkChannels(reader.getImageTypes(0));
      }
      reader.addIIOReadWarningListener(
          (source, warning) -> remarks.accept("is damaged: " + warning));
      return codes(reader.read(0), remarks);
    } catch (RuntimeException e) { // of which broken files cause all kinds
      throw new IOException("broken: " + Reasons.of(e), e);
    } finally {
      reader.dispose();
    }
  }

  /** Refuses the four inks of CMYK, which are mixed otherwise than light. */
  private static void checkChannels(Iterator<ImageTypeSpecifier> types) throws IOException {
    if (!types.hasNext() || types.next().getNumBands() > 3) {
      throw new IOException("neither grey nor of red, green and blue; of inks (CMYK)?");
    }
  }

  private static void checkSize(int width, int height) throws IOException {
    try {
      ByteImage.checkSize(width, height);
    } catch (IllegalArgumentException e) {
      throw new IOException(e.getMessage(), e);
    }
    long available = Runtime.getRuntime().maxMemory();
    if (BYTES_PER_PIXEL * width * height > available) {
      throw new IOException(
          "its " + width + "x" + height + " pixels do not fit into the memory that Java may use");
    }
  }

  /** Takes over all samples, those of more than eight bits rounded. */
  private static ByteImage codes(BufferedImage image, Consumer<String> remarks) {
    Samples samples = new Samples(image);
    int width = image.getWidth();
    byte[] rgb = new byte[3 * width * image.getHeight()];
    boolean transparent = false;
    for (int y = 0; y < image.getHeight(); y++) {
      samples.row(y);
      for (int x = 0; x < width; x++) {
        transparent |= samples.isTransparent(x);
        for (int channel = 0; channel < 3; channel++) {
          int sample = samples.of(x, channel);
          int code = (2 * 255 * sample + samples.white()) / (2 * samples.white());
          rgb[3 * (y * width + x) + channel] = (byte) code;
        }
      }
    }
    if (transparent) {
      remarks.accept("is transparent in places, which has no effect here");
    }
    return new ByteImage(width, image.getHeight(), rgb);
  }
}
