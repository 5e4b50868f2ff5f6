package glint.desktop;

import com.google.gson.GsonBuilder;
import glint.verify.Outcome;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The rows of {@code glint verify}: printed one by one, or all at the end as JSON. */
final class CaseTable {

  private final PrintWriter out;
  private final boolean json;
  private final String format;
  private final List<Row> rows = new ArrayList<>();

  /** The rows as JSON names them. */
  private record Rows(List<Row> cases) {}

  private record Row(
      String id,
      String what,
      long tried,
      long wrong,
      Double worst,
      double bound,
      String unit,
      boolean passed) {

    static Row of(Outcome o) {
      // An error that is not finite has no number in JSON; passed tells of it.
      Double worst = Double.isFinite(o.worst()) ? (Double) o.worst() : null;
      return new Row(
          o.id(), o.what(), o.tried(), o.wrong(), worst, o.bound(), o.unit(), o.passed());
    }
  }

  /**
   * Begins a table.
   *
   * @param idWidth the length of the longest identifier
   */
  CaseTable(PrintWriter out, boolean json, int idWidth) {
    this.out = out;
    this.json = json;
    format = "%-" + idWidth + "s %10s %6s %12s %12s  %s%n";
    if (!json) {
      out.printf(Locale.ROOT, format, "case", "tried", "wrong", "worst", "bound", "what");
    }
  }

  /** Adds a row. */
  void add(Outcome o) {
    rows.add(Row.of(o));
    if (!json) {
      boolean measured = o.bound() > 0;
      String worst = measured ? String.format(Locale.ROOT, "%.3g", o.worst()) : "-";
      String bound = measured ? String.format(Locale.ROOT, "%.3g", o.bound()) : "-";
      String what = (o.passed() ? "" : "WRONG: ") + o.what() + (measured ? unit(o) : "");
      out.printf(Locale.ROOT, format, o.id(), o.tried(), o.wrong(), worst, bound, what);
      out.flush();
    }
  }

  /** Adds a row and, below it, the command that shows what is wrong with it. */
  void add(Outcome o, String command) {
    if (o.passed()) {
      add(o);
    } else if (json) {
      String what = o.what() + "; to see it: " + command;
      add(new Outcome(o.id(), what, o.tried(), o.wrong(), o.worst(), o.bound(), o.unit()));
    } else {
      add(o);
      out.println("  to see it: " + command);
    }
  }

  private static String unit(Outcome o) {
    return " [" + o.unit() + "]";
  }

  /** Ends the table; returns how many rows are wrong. */
  long end() {
    long wrong = rows.stream().filter(row -> !row.passed()).count();
    if (json) {
      out.println(new GsonBuilder().serializeNulls().create().toJson(new Rows(rows)));
    } else {
      out.println(Figures.count(rows.size(), "case") + ", " + wrong + " wrong");
    }
    return wrong;
  }
}
