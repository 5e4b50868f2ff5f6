package glint.desktop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Writes a file so that it is either there and whole or not there at all. */
final class AtomicFile {

  /** What is being written at this moment. */
  private static final Set<Path> UNFINISHED = ConcurrentHashMap.newKeySet();

  /** Writes the bytes of a file. */
  interface Content {
    /** Writes them all to the file at a path, and closes it. */
    void writeTo(Path path) throws IOException;
  }

  private AtomicFile() {}

  /**
   * Writes a hidden temporary file beside the target and then renames it.
   *
   * <p>A target that is no ordinary file, such as {@code /dev/stdout}, is written as it stands, and
   * so is what a link leads to: a rename would put the file in the link's place.
   *
   * @throws IOException if that fails; the target is then as it was before
   */
  static void write(Path target, Content content) throws IOException {
    boolean ordinary = Files.isRegularFile(target, LinkOption.NOFOLLOW_LINKS);
    if (Files.exists(target) && !ordinary && !Files.isDirectory(target)) {
      content.writeTo(target);
      return;
    }
    Path temporary =
        target.resolveSibling(
            "." + target.getFileName() + "." + ProcessHandle.current().pid() + ".tmp");
    UNFINISHED.add(temporary);
    try {
      content.writeTo(temporary);
      Files.move(temporary, target, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(temporary);
      UNFINISHED.remove(temporary);
    }
  }

  /** Deletes what is not finished, when the process must end now. */
  static void deleteUnfinished() {
    for (Path temporary : UNFINISHED) {
      try {
        Files.deleteIfExists(temporary);
      } catch (IOException e) {
        // The process ends, and a hidden file that cannot be deleted harms nobody.
        continue;
      }
    }
  }
}
