package glint.desktop.window;

import glint.color.Transfer;
import glint.image.Image;
import glint.render.Statistics;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/** Writes and reads images, as the other commands do; called on a thread of its own. */
public interface ImageStore {

  /**
   * Writes an image; a name that ends in .pfm says that it is of linear light, else it is a PNG.
   *
   * @param statistics of the whole render; absent if it was not done, or not as the file has it
   * @throws IOException if that cannot be; its message says why in words for people
   */
  void write(Picked picked, Image image, Optional<Statistics> statistics, Path file)
      throws IOException;

  /**
   * Reads a PNG or PFM image.
   *
   * @param transfer how a PNG's codes were made
   * @throws IOException if that cannot be; its message says why in words for people
   */
  Image read(Path file, Transfer transfer) throws IOException;
}
