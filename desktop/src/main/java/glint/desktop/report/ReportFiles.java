package glint.desktop.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The files that a report becomes. */
public final class ReportFiles {

  /** What their names begin with. */
  private static final String NAME = "speed-and-error";

  private ReportFiles() {}

  /** Returns the texts of the files by their names, those first that the page refers to. */
  public static Map<String, String> of(Report report) {
    List<Block> page = ReportPage.of(report, NAME);
    Map<String, String> files = new LinkedHashMap<>();
    for (Block block : page) {
      if (block instanceof Block.Figure figure) {
        files.put(figure.file(), figure.svg());
      }
    }
    files.put(NAME + ".json", ReportJson.of(report));
    files.put(NAME + ".md", Markdown.of(page));
    files.put(NAME + ".html", Html.of(page));
    return files;
  }
}
