package glint.math;

/** A value that a scene cannot hold, with the name under which a person wrote it. */
public final class BadValueException extends IllegalArgumentException {

  private static final long serialVersionUID = 1;

  private final String field;

  /** Names the field and says what is wrong with it: "must be positive, but is -1". */
  public BadValueException(String field, String problem) {
    super(field + " " + problem);
    this.field = field;
  }

  /** Returns the field's name as scene files spell it. */
  public String field() {
    return field;
  }
}
