package glint.android;

/**
 * How far a render has come; immutable.
 *
 * @param part of the work that is done, 0 to 1
 * @param seconds since it began, without pauses
 * @param left the seconds that are left, about; infinite if that cannot be told
 * @param rays traced so far
 * @param error what is claimed for the picture, in display levels; infinite while unknown
 */
record Status(State state, double part, double seconds, double left, long rays, double error) {

  /** Where a render stands. */
  enum State {
    PREPARING,
    RENDERING,
    PAUSED,
    DONE,
    STOPPED,
    /** It does not fit into memory, and was not begun. */
    REFUSED,
    /** Memory ran out all the same. */
    OUT_OF_MEMORY;

    /** Returns whether nothing more will come. */
    boolean isOver() {
      return ordinal() >= DONE.ordinal();
    }
  }
}
