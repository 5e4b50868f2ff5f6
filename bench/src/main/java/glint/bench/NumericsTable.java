package glint.bench;

import glint.verify.HardCase;
import glint.verify.HardCases;
import glint.verify.Outcome;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Writes what every hard case found on this machine into docs/numerics.md, between its marks. */
public final class NumericsTable {

  private static final String BEGIN = "<!-- begin: ./gradlew :bench:numerics -->\n";
  private static final String END = "<!-- end -->\n";
  private static final int BAR = 10;

  private NumericsTable() {}

  /**
   * Replaces the table.
   *
   * @param args the page, the commit, and optionally "long"
   */
  public static void main(String[] args) throws IOException {
    Path page = Path.of(args[0]);
    boolean effort = args.length > 2 && args[2].equals("long");
    String text = Files.readString(page);
    int from = text.indexOf(BEGIN);
    int to = text.indexOf(END);
    if (from < 0 || to < from) {
      throw new IOException(page + " has no marks for the table");
    }
    String table = table(effort ? HardCase.Effort.LONG : HardCase.Effort.SHORT, args[1]);
    Files.writeString(page, text.substring(0, from + BEGIN.length()) + table + text.substring(to));
  }

  private static String table(HardCase.Effort effort, String commit) {
    StringBuilder out = new StringBuilder();
    out.append(
        String.format(
            Locale.ROOT,
            "Java %s on %s %s, commit %s, `glint verify%s`.%n%n",
            System.getProperty("java.version"),
            System.getProperty("os.name"),
            System.getProperty("os.arch"),
            commit,
            effort == HardCase.Effort.LONG ? " --long" : ""));
    out.append("| case | what | tried | wrong | worst | bound | unit | of the bound |\n");
    out.append("|---|---|---|---|---|---|---|---|\n");
    for (HardCase each : HardCases.all()) {
      Outcome o = each.run(effort);
      boolean measured = o.bound() > 0;
      out.append(
          String.format(
              Locale.ROOT,
              "| %s | %s | %d | %d | %s | %s | %s | %s |%n",
              o.id(),
              o.what().replace("|", "\\|"),
              o.tried(),
              o.wrong(),
              measured ? String.format(Locale.ROOT, "%.3g", o.worst()) : "–",
              measured ? String.format(Locale.ROOT, "%.3g", o.bound()) : "–",
              measured ? o.unit().replace("|", "\\|") : "–",
              measured ? bar(o.worst() / o.bound()) : "–"));
    }
    return out.append('\n').toString();
  }

  /** Draws how much of the bound the worst error takes: ten boxes are all of it. */
  private static String bar(double share) {
    int full = (int) Math.ceil(BAR * Math.min(Math.max(share, 0), 1));
    return "▮".repeat(full) + "▯".repeat(BAR - full);
  }
}
