package glint.desktop;

/** A scene or file that could not be done, and the one line that says why; immutable. */
record Failed(String name, String message) {}
