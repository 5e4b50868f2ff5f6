package glint.desktop.window;

import java.awt.Rectangle;
import java.io.IOException;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Properties;

/** What the window remembers from one time to the next, in a small file; not thread-safe. */
final class Remembered {

  private static final int MOST_RECENT = 12;

  private final Path file;
  private final Properties values = new Properties();

  private Remembered(Path file) {
    this.file = file;
  }

  /** Reads what a file holds; nothing if it is not there or broken. */
  static Remembered read(Path file) {
    Remembered memory = new Remembered(file);
    if (Files.exists(file)) {
      try (Reader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
        memory.values.load(in);
      } catch (IOException | IllegalArgumentException e) {
        memory.values.clear();
      }
    }
    return memory;
  }

  /** Writes all of it; what cannot be written is forgotten. */
  void write() {
    try {
      Files.createDirectories(file.getParent());
      try (Writer out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
        values.store(out, "The window of Glint");
      }
    } catch (IOException e) {
      return; // the next time begins as the first
    }
  }

  /** Returns where the window was. */
  Optional<Rectangle> bounds() {
    Optional<Integer> width = number("width");
    Optional<Integer> height = number("height");
    return number("x").isPresent() && width.isPresent() && height.isPresent()
        ? Optional.of(
            new Rectangle(number("x").get(), number("y").orElse(0), width.get(), height.get()))
        : Optional.empty();
  }

  /** Remembers where the window is. */
  void bounds(Rectangle bounds) {
    number("x", bounds.x);
    number("y", bounds.y);
    number("width", bounds.width);
    number("height", bounds.height);
  }

  /** Returns a number that was remembered. */
  Optional<Integer> number(String name) {
    try {
      return Optional.ofNullable(values.getProperty(name)).map(Integer::valueOf);
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** Remembers a number. */
  void number(String name, int value) {
    values.setProperty(name, String.valueOf(value));
  }

  /** Returns a word that was remembered. */
  Optional<String> word(String name) {
    return Optional.ofNullable(values.getProperty(name));
  }

  /** Remembers a word. */
  void word(String name, String value) {
    values.setProperty(name, value);
  }

  /** Returns the files that were opened last, the newest first. */
  List<Path> recent() {
    List<Path> files = new ArrayList<>();
    for (int i = 0; i < MOST_RECENT; i++) {
      try {
        word("recent." + i).map(Path::of).ifPresent(files::add);
      } catch (InvalidPathException e) {
        continue; // of another system
      }
    }
    return files;
  }

  /** Remembers that a file was opened. */
  void opened(Path opened) {
    List<Path> files = recent();
    Path whole = opened.toAbsolutePath().normalize();
    files.remove(whole);
    files.add(0, whole);
    for (int i = 0; i < Math.min(MOST_RECENT, files.size()); i++) {
      word("recent." + i, files.get(i).toString());
    }
  }
}
