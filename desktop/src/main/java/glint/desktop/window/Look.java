package glint.desktop.window;

/** What the picture view shows of a render. */
enum Look {
  PICTURE,
  ERROR,
  SAMPLES,
  SPLIT,
  DIFFERENCE;

  /** Returns whether it takes another image to compare with. */
  boolean compares() {
    return this == SPLIT || this == DIFFERENCE;
  }
}
