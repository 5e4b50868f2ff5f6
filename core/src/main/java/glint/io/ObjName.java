package glint.io;

/**
 * A name in an OBJ file and where it stands; immutable.
 *
 * @param line from 1, or 0 if it stands nowhere
 * @param column from 1
 */
public record ObjName(String text, int line, int column) {

  Place place() {
    return new Place(line, column);
  }
}
