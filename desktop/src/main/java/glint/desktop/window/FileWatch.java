package glint.desktop.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Tells when scene files, or what they name, have changed: it looks at the times of all of them now
 * and then, which serves on every system, in every folder and for every way of saving.
 */
public final class FileWatch {

  /** The time of a file that is not there. */
  public static final FileTime MISSING = FileTime.fromMillis(Long.MIN_VALUE);

  private static final long PERIOD_MILLIS = 120;

  private final Consumer<Path> changed;
  private final Map<Path, Map<Path, FileTime>> read = new LinkedHashMap<>();
  private final Map<Path, Map<Path, FileTime>> seen = new HashMap<>();

  /**
   * Sets up a watch over nothing.
   *
   * @param changed hears of scene files to read again, on the thread of the watch
   */
  FileWatch(Consumer<Path> changed) {
    this.changed = changed;
  }

  /** Begins to look, on a thread of some workers, until these are ended. */
  void start(Workers workers) {
    workers.every(PERIOD_MILLIS, this::look);
  }

  /** Watches a scene file, of which is known which files it needs and their times when read. */
  synchronized void watch(Path file, Map<Path, FileTime> parts) {
    read.put(file, parts);
    seen.remove(file);
  }

  /** Looks once; a change counts when it is the same as a look before, so that writing is over. */
  private void look() {
    Map<Path, Map<Path, FileTime>> known;
    synchronized (this) {
      known = new LinkedHashMap<>(read);
    }
    known.forEach(
        (file, parts) -> {
          Map<Path, FileTime> now = new LinkedHashMap<>();
          parts.keySet().forEach(part -> now.put(part, time(part)));
          if (isNew(file, parts, now)) {
            changed.accept(file);
          }
        });
  }

  private synchronized boolean isNew(
      Path file, Map<Path, FileTime> parts, Map<Path, FileTime> now) {
    boolean current = parts.equals(read.get(file)); // not read again meanwhile
    if (!current || now.equals(parts)) {
      seen.remove(file);
      return false;
    }
    if (!now.equals(seen.put(file, now))) {
      return false;
    }
    read.put(file, now);
    return true;
  }

  private static FileTime time(Path file) {
    try {
      return Files.getLastModifiedTime(file);
    } catch (IOException e) {
      return MISSING;
    }
  }
}
