package glint.desktop;

import glint.io.Suggestion;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Reads the words and numbers of options. */
final class Words {

  private Words() {}

  /**
   * Returns the constant that a word names in lower case.
   *
   * @throws ParameterException if none has this name; the message lists all
   */
  static <E extends Enum<E>> E pick(
      CommandSpec command, String option, String name, Class<E> type) {
    List<String> known = new ArrayList<>();
    for (E value : type.getEnumConstants()) {
      String word = value.name().toLowerCase(Locale.ROOT);
      if (word.equals(name)) {
        return value;
      }
      known.add(word);
    }
    String message =
        option
            + " can be "
            + String.join(", ", known)
            + ", but not '"
            + name
            + "'"
            + Suggestion.hint(name, known);
    throw wrong(command, message);
  }

  /**
   * Returns a number that is in its range.
   *
   * @throws ParameterException if it is not; the message says the range
   */
  static int inRange(CommandSpec command, String option, int n, int least, int most) {
    if (n < least || n > most) {
      throw wrong(command, option + " must be " + least + " to " + most + ", but is " + n);
    }
    return n;
  }

  /** Returns what says that a command is used wrongly. */
  static ParameterException wrong(CommandSpec command, String message) {
    return new ParameterException(command.commandLine(), message);
  }

  /**
   * Returns the seconds of a time such as 30s, 5m or 1h.
   *
   * @throws ParameterException if it is none, or zero
   */
  static double seconds(CommandSpec command, String option, String text) {
    if (!text.matches("[0-9]{1,6}(\\.[0-9]{1,6})?[smh]") || !text.matches(".*[1-9].*")) {
      throw new ParameterException(
          command.commandLine(),
          option + " must be a time above zero such as 30s, 5m or 1h, but is '" + text + "'");
    }
    int end = text.length() - 1;
    double factor = text.charAt(end) == 's' ? 1 : text.charAt(end) == 'm' ? 60 : 3600;
    return factor * Double.parseDouble(text.substring(0, end));
  }

  /** Returns an error that can be rendered to, or fails. */
  static double levels(CommandSpec command, double levels) {
    if (!(levels > 0 && levels <= 255)) {
      throw wrong(command, "--max-error must be more than 0 and at most 255, but is " + levels);
    }
    return levels;
  }
}
