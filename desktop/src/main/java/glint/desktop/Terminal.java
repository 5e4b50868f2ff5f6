package glint.desktop;

import java.io.Console;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Finds out whether somebody watches. */
final class Terminal {

  private Terminal() {}

  /** Returns whether standard error is a terminal on which a line can be drawn over. */
  static boolean isWatched() {
    return System.console() != null
        && isTerminal(System.console())
        && !"dumb".equals(System.getenv("TERM"))
        && !isRedirected(Path.of("/proc/self/fd/2"));
  }

  /** From Java 22 on there may be a console without a terminal; it then says so. */
  private static boolean isTerminal(Console console) {
    try {
      return (boolean) Console.class.getMethod("isTerminal").invoke(console);
    } catch (ReflectiveOperationException e) {
      return true;
    }
  }

  /** The console is about standard input and output; Linux tells where standard error goes. */
  private static boolean isRedirected(Path stream) {
    try {
      return Files.exists(stream) && !Files.readSymbolicLink(stream).startsWith("/dev");
    } catch (IOException e) {
      return false;
    }
  }
}
