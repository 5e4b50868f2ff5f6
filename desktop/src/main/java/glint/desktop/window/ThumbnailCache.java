package glint.desktop.window;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

/** Small pictures on disk, by what the scene's files hold; what cannot be kept is made again. */
final class ThumbnailCache {

  /** More are not kept: the oldest go first. */
  private static final int MOST = 1000;

  private final Path folder;

  /**
   * Sets up a cache.
   *
   * @param folder made when it is needed
   */
  ThumbnailCache(Path folder) {
    this.folder = folder;
  }

  /** Returns what tells the picture of a scene from all others. */
  static String key(Picked picked) {
    String name = picked.digest() + "\n" + picked.scene().name();
    return UUID.nameUUIDFromBytes(name.getBytes(StandardCharsets.UTF_8)).toString();
  }

  /** Returns a scene's picture, if it is there and whole. */
  Optional<BufferedImage> read(Picked picked) {
    try {
      Path file = file(picked);
      return Files.exists(file)
          ? Optional.ofNullable(ImageIO.read(file.toFile()))
          : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** Keeps a scene's picture. */
  void write(Picked picked, BufferedImage picture) {
    Path temporary = folder.resolve(key(picked) + "." + ProcessHandle.current().pid() + ".tmp");
    try {
      Files.createDirectories(folder);
      ImageIO.write(picture, "png", temporary.toFile());
      Files.move(temporary, file(picked), StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      return; // a full disk, or one that may not be written to
    }
  }

  /** Deletes the oldest pictures if there are many. */
  void prune() {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (Stream<Path> files = Files.list(folder)) {
      List<Path> oldest = files.sorted(Comparator.comparing(ThumbnailCache::time)).toList();
      for (Path file : oldest.subList(0, Math.max(0, oldest.size() - MOST))) {
        Files.deleteIfExists(file);
      }
    } catch (IOException e) {
      return; // another time
    }
  }

  private static FileTime time(Path file) {
    try {
      return Files.getLastModifiedTime(file);
    } catch (IOException e) {
      return FileTime.fromMillis(0);
    }
  }

  private Path file(Picked picked) {
    return folder.resolve(key(picked) + ".png");
  }
}
