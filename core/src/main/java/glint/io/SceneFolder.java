package glint.io;

import glint.image.ByteImage;
import java.io.IOException;
import java.io.InputStream;
import java.util.function.Consumer;

/**
 * What a front end does for readers: it opens the files that a scene file names, in that one's own
 * folder, and decodes images as its platform can.
 */
public interface SceneFolder {

  /**
   * Opens a file; the reader closes it.
   *
   * @param path as the scene file says it: relative to the scene file's folder, or absolute
   * @throws IOException if that cannot be; its message says why in words for people: "no such file"
   */
  InputStream open(String path) throws IOException;

  /** Returns what messages call such a file. */
  default String name(String path) {
    return path;
  }

  /**
   * Decodes a PNG or JPEG image to its codes as they stand, without alpha and colour profile.
   *
   * @param in the bytes; left open
   * @param remarks is told what is left aside, in words that follow the image's name: "has ..."
   * @throws IOException if that cannot be; its message says why in words for people
   */
  default ByteImage decode(InputStream in, Consumer<String> remarks) throws IOException {
    throw new IOException("images are not decoded here");
  }
}
