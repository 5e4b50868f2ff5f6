package glint.desktop;

import glint.io.Suggestion;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Reads the words of options. */
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
    throw new ParameterException(command.commandLine(), message);
  }
}
