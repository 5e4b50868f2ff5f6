package glint.desktop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Makes the folders that files go to. */
final class Folders {

  private Folders() {}

  /**
   * Makes a folder and those above it, where they are missing.
   *
   * @throws RunException if that is not possible, or nothing can be written into it
   */
  static void make(Path folder) throws RunException {
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw new RunException(folder + ": is a file, not a folder");
    }
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new RunException("cannot make the folder " + Reasons.of(folder, e), e);
    }
    if (!Files.isWritable(folder)) {
      throw new RunException(folder + ": no permission to write into this folder");
    }
  }
}
