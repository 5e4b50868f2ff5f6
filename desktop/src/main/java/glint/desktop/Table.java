package glint.desktop;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;

/** Rows of words under each other, each column as wide as it must be. */
final class Table {

  private static final String INDENT = "  ";

  private final List<String[]> rows = new ArrayList<>();

  /** Begins a table with its first row. */
  Table(String... head) {
    rows.add(head);
  }

  /** Adds a row of as many words as the first has. */
  void row(String... words) {
    rows.add(words);
  }

  /** Prints all rows. */
  void print(PrintWriter out) {
    int columns = rows.get(0).length;
    int[] widths = new int[columns];
    for (String[] row : rows) {
      for (int i = 0; i < columns; i++) {
        widths[i] = Math.max(widths[i], row[i].length());
      }
    }
    for (String[] row : rows) {
      StringBuilder line = new StringBuilder();
      for (int i = 0; i < columns; i++) {
        line.append(INDENT).append(row[i]).append(" ".repeat(widths[i] - row[i].length()));
      }
      out.println(line.toString().stripTrailing());
    }
  }
}
