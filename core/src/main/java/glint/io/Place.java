package glint.io;

/** A line and a column in a file, both from 1. */
record Place(int line, int column) {

  /** Of what concerns the file as a whole. */
  static final Place NONE = new Place(0, 0);

  @Override
  public String toString() {
    return "line " + line + ", column " + column;
  }
}
