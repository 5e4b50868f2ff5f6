package glint.io;

import java.io.IOException;
import java.io.InputStream;

/** Opens the files that a scene file names: its own folder, seen through the front end. */
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
}
