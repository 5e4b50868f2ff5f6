package glint.desktop;

import com.google.gson.GsonBuilder;
import glint.verify.HardCase;
import glint.verify.HardCases;
import glint.verify.Outcome;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code glint verify}: runs the numerical hard cases. */
@Command(
    name = "verify",
    description = "Runs the numerical hard cases on this machine and prints one row for each.",
    mixinStandardHelpOptions = true)
final class VerifyCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Option(names = "--json", description = "Prints one JSON object instead of a table.")
  private boolean json;

  @Option(names = "--long", description = "Tries more of each, which takes minutes.")
  private boolean effort;

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

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    List<Row> rows = new ArrayList<>();
    if (!json) {
      out.printf(Locale.ROOT, "%-14s %10s %6s %12s %12s  %s%n", HEAD);
    }
    for (HardCase each : HardCases.all()) {
      Outcome o = each.run(effort ? HardCase.Effort.LONG : HardCase.Effort.SHORT);
      rows.add(Row.of(o));
      if (!json) {
        print(o, out);
      }
    }
    long wrong = rows.stream().filter(row -> !row.passed()).count();
    if (json) {
      out.println(new GsonBuilder().serializeNulls().create().toJson(new Rows(rows)));
    } else {
      out.println(Figures.count(rows.size(), "case") + ", " + wrong + " wrong");
    }
    return wrong == 0 ? ExitCode.DONE : ExitCode.FAILED;
  }

  private static final Object[] HEAD = {"case", "tried", "wrong", "worst", "bound", "what"};

  private static void print(Outcome o, PrintWriter out) {
    boolean measured = o.bound() > 0;
    String worst = measured ? String.format(Locale.ROOT, "%.3g", o.worst()) : "-";
    String bound = measured ? String.format(Locale.ROOT, "%.3g", o.bound()) : "-";
    String what = o.what() + (measured ? " [" + o.unit() + "]" : "");
    String mark = o.passed() ? "" : "WRONG: ";
    out.printf(
        Locale.ROOT,
        "%-14s %10d %6d %12s %12s  %s%s%n",
        o.id(),
        o.tried(),
        o.wrong(),
        worst,
        bound,
        mark,
        what);
    out.flush();
  }
}
