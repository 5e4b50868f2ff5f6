package glint.desktop;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Finds what somebody meant who mistyped a word. */
final class Words {

  private Words() {}

  /** Returns "; did you mean 'x'?" for the known word that is nearest, or "" if none is near. */
  static String suggestion(String word, Collection<String> known) {
    return nearest(word, known).map(x -> "; did you mean '" + x + "'?").orElse("");
  }

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
            + suggestion(name, known);
    throw new ParameterException(command.commandLine(), message);
  }

  private static Optional<String> nearest(String word, Collection<String> known) {
    String best = null;
    // Half of a word may be wrong, but not more than that
    int least = Math.max(1, word.length() / 2) + 1;
    for (String candidate : known) {
      int distance = distance(word, candidate);
      if (distance < least) {
        least = distance;
        best = candidate;
      }
    }
    return Optional.ofNullable(best);
  }

  /** The least number of letters inserted, deleted or changed (Levenshtein), ignoring case. */
  private static int distance(String a, String b) {
    int[] row = new int[b.length() + 1];
    for (int j = 0; j <= b.length(); j++) {
      row[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        char x = Character.toLowerCase(a.charAt(i - 1));
        char y = Character.toLowerCase(b.charAt(j - 1));
        int changed = diagonal + (x == y ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(changed, Math.min(row[j], row[j - 1]) + 1);
      }
    }
    return row[b.length()];
  }
}
