package glint.desktop.window;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A place in a text file; immutable.
 *
 * @param line from 1
 * @param column in characters, from 1
 */
record Place(Path file, int line, int column) {

  private static final Pattern BEGINNING =
      Pattern.compile("(.+?):([0-9]{1,9}):([0-9]{1,9}): .*", Pattern.DOTALL);

  /** Returns the place that a problem's line begins with, as file:line:column. */
  static Optional<Place> of(String problem) {
    Matcher parts = BEGINNING.matcher(problem);
    if (!parts.matches()) {
      return Optional.empty();
    }
    try {
      int line = Integer.parseInt(parts.group(2));
      return Optional.of(
          new Place(Path.of(parts.group(1)), line, Integer.parseInt(parts.group(3))));
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  @Override
  public String toString() {
    return file + ":" + line + ":" + column;
  }
}
