package glint.io;

/** Something that a reader does not refuse, told once for a whole model. */
final class ObjNote {

  private final String message;
  private Place first;
  private int count;

  ObjNote(String message) {
    this.message = message;
  }

  void at(Place place) {
    first = first == null ? place : first;
    count++;
  }

  void report(Problems notes) {
    if (count > 0) {
      notes.report(first, message + (count == 1 ? "" : " (" + count + " times in this file)"));
    }
  }
}
