package glint.desktop.window;

/** Text for labels that take HTML. */
final class Html {

  private Html() {}

  /** Returns a text in which nothing is markup. */
  static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }
}
