package glint.io;

import java.util.Locale;

/** Ends the reading of a statement of an OBJ file; says what is wrong with which token. */
final class BadObj extends RuntimeException {

  private static final long serialVersionUID = 1;

  private final transient Place place;
  private final boolean hopeless;
  private final boolean notFinite;

  BadObj(Place place, String message) {
    this(place, message, false, false);
  }

  private BadObj(Place place, String message, boolean hopeless, boolean notFinite) {
    super(message, null, false, false);
    this.place = place;
    this.hopeless = hopeless;
    this.notFinite = notFinite;
  }

  static BadObj noText(Place place, byte code) {
    String hex = String.format(Locale.ROOT, "0x%02X", code);
    return new BadObj(
        place, "holds a control character (" + hex + "): not a text file?", true, false);
  }

  static BadObj tooLong(Place place) {
    return new BadObj(place, "longer than " + ObjSource.LONGEST + " characters: not a number");
  }

  static BadObj tooLongName(Place place) {
    return new BadObj(place, "a name has up to " + ObjSource.LONGEST + " characters");
  }

  static BadObj noNumber(Place place, String word) {
    String quoted = SourceText.quote(word);
    String lower = word.toLowerCase(Locale.ROOT);
    if (lower.matches("[-+]?(1\\.#)?(nan|inf|ind|qnan|snan).*")) {
      return new BadObj(place, "not a finite number: " + quoted, false, true);
    }
    String remedy = word.contains(",") ? "; fractions follow a point" : "";
    return new BadObj(place, "expected a number, but found " + quoted + remedy);
  }

  static BadObj zeroIndex(Place place, String word) {
    String quoted = SourceText.quote(word);
    return new BadObj(place, "index 0 in " + quoted + ": the first is 1, and the last is -1");
  }

  static BadObj noCorner(Place place, String word) {
    return new BadObj(
        place,
        "expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found " + SourceText.quote(word));
  }

  static BadObj noPoint(Place place, String word) {
    return new BadObj(place, "no model has as many points as " + SourceText.quote(word) + " needs");
  }

  /** There is no point, or what the noun says, of that number. */
  static BadObj none(Place place, String noun, int index, int count) {
    String there = count == 1 ? "there is 1 " + noun : "there are " + count + " " + noun + "s";
    String where = index < 0 ? " before this" : " in the model";
    return new BadObj(place, "no " + noun + " " + index + ": " + there + where);
  }

  Place place() {
    return place;
  }

  /** Returns whether NaN or an infinity stands where a number should. */
  boolean isNotFinite() {
    return notFinite;
  }

  /** Returns whether there is no use in reading on. */
  boolean hopeless() {
    return hopeless;
  }
}
