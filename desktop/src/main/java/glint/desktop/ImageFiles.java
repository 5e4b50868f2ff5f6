package glint.desktop;

import glint.color.Transfer;
import glint.image.Image;
import glint.io.Pfm;
import glint.scene.Scene;
import java.awt.image.BufferedImage;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads images into linear light. */
final class ImageFiles {

  private ImageFiles() {}

  /**
   * Reads a PFM or PNG image; the first bytes say which it is.
   *
   * <p>A PNG may be of any kind and depth; its samples are decoded by the transfer curve, and alpha
   * is left aside.
   *
   * @throws RunException if the file is not such an image
   */
  static Image read(Path path, Transfer transfer) throws RunException {
    if (Files.isDirectory(path)) {
      throw new RunException(path + ": is a folder, not an image");
    }
    try (InputStream in = new BufferedInputStream(Files.newInputStream(path), 1 << 16)) {
      in.mark(2);
      int first = in.read();
      int second = in.read();
      in.reset();
      if (first == 'P' && (second == 'F' || second == 'f')) {
        return Pfm.read(in, path.toString());
      } else if (first == 0x89 && second == 'P') {
        return decode(readPng(in), transfer);
      }
      throw new IOException("neither a PNG nor a PFM image");
    } catch (IOException | RuntimeException e) {
      String reason = Reasons.of(e);
      String begin = path + ": ";
      throw new RunException(reason.startsWith(begin) ? reason : begin + reason, e);
    }
  }

  private static BufferedImage readPng(InputStream in) throws IOException, RunException {
    ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
    try (ImageInputStream stream = new MemoryCacheImageInputStream(in)) {
      reader.setInput(stream, true, true);
      int width = reader.getWidth(0);
      int height = reader.getHeight(0);
      Scene.checkSize(width, height);
      Memory.check(width, height, 0);
      return reader.read(0);
    } finally {
      reader.dispose();
    }
  }

  private static Image decode(BufferedImage png, Transfer transfer) {
    Samples samples = new Samples(png);
    double white = samples.white();
    Image image = new Image(png.getWidth(), png.getHeight());
    for (int y = 0; y < image.height(); y++) {
      samples.row(y);
      for (int x = 0; x < image.width(); x++) {
        image.set(
            x,
            y,
            transfer.decode(samples.of(x, 0) / white),
            transfer.decode(samples.of(x, 1) / white),
            transfer.decode(samples.of(x, 2) / white));
      }
    }
    return image;
  }
}
