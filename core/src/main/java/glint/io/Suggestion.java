package glint.io;

import java.util.Collection;
import java.util.Locale;

/** Finds the word that a person probably meant. */
public final class Suggestion {

  private static final int LONGEST = 40;

  private Suggestion() {}

  /** Returns {@code "; did you mean 'x'?"} for the nearest known word, or "" if none is near. */
  public static String hint(String word, Collection<String> known) {
    String nearest = nearest(word, known);
    return nearest == null ? "" : "; did you mean '" + nearest + "'?";
  }

  /** Returns the hint, or else the list of what there is, as {@code "; known here: a, b"}. */
  static String hintOrList(String word, Collection<String> known) {
    String hint = hint(word, known);
    if (!hint.isEmpty() || known.isEmpty()) {
      return hint;
    }
    int shown = 0;
    StringBuilder list = new StringBuilder("; known here:");
    for (String each : known) {
      if (shown == 15) {
        list.append(" and ").append(known.size() - shown).append(" more");
        break;
      }
      list.append(shown == 0 ? " " : ", ").append(each);
      shown++;
    }
    return list.toString();
  }

  /** Returns the first known word with the fewest typing errors, at most a third, or null. */
  static String nearest(String word, Collection<String> known) {
    if (word.length() > LONGEST) {
      return null;
    }
    String nearest = null;
    int fewest = Math.max(1, Math.min(3, word.length() / 3)) + 1;
    for (String candidate : known) {
      if (Math.abs(candidate.length() - word.length()) < fewest) {
        int errors = errors(word.toLowerCase(Locale.ROOT), candidate.toLowerCase(Locale.ROOT));
        // A word that shares nothing with the candidate is no typing error.
        if (errors < fewest && errors < candidate.length()) {
          nearest = candidate;
          fewest = errors;
        }
      }
    }
    return nearest;
  }

  /**
   * Counts the inserted, lost, wrong and swapped neighbouring letters between two words: the
   * optimal string alignment distance (Damerau 1964).
   */
  private static int errors(String a, String b) {
    int[][] d = new int[a.length() + 1][b.length() + 1];
    for (int i = 0; i <= a.length(); i++) {
      for (int j = 0; j <= b.length(); j++) {
        if (i == 0 || j == 0) {
          d[i][j] = i + j;
          continue;
        }
        boolean same = a.charAt(i - 1) == b.charAt(j - 1);
        int best = d[i - 1][j - 1] + (same ? 0 : 1);
        best = Math.min(best, 1 + Math.min(d[i - 1][j], d[i][j - 1]));
        boolean swapped =
            i > 1
                && j > 1
                && a.charAt(i - 1) == b.charAt(j - 2)
                && a.charAt(i - 2) == b.charAt(j - 1);
        d[i][j] = swapped ? Math.min(best, d[i - 2][j - 2] + 1) : best;
      }
    }
    return d[a.length()][b.length()];
  }
}
