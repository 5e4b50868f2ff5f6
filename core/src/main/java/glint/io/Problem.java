package glint.io;

/**
 * Something that a scene file or a model says wrongly, or that its reader had to assume; immutable.
 *
 * @param file the file's name as the caller gave it
 * @param line the line, from 1, or 0 where the problem has no place
 * @param column the column in characters, from 1, or 0 where the problem has no place
 * @param message one line of text
 */
public record Problem(String file, int line, int column, String message) {

  /** Returns {@code "file:line:column: message"}, or {@code "file: message"} without a place. */
  @Override
  public String toString() {
    return line == 0 ? file + ": " + message : file + ":" + line + ":" + column + ": " + message;
  }
}
