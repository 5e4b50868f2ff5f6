package glint.desktop.report;

import glint.report.Measurement.Cost;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Draws error against cost as SVG: a legend, and one small chart for each scene. */
final class PanelChart {

  private static final int COLUMNS = 3;
  private static final int LEGEND = 52;
  private static final int LEGEND_WIDTH = 800;

  private PanelChart() {}

  /** Returns the chart of all scenes that have an error to draw; nothing if none has. */
  static Optional<String> of(List<Report.Entry> entries, Cost cost) {
    List<Report.Entry> shown = new ArrayList<>(entries);
    shown.removeIf(entry -> Panel.drawn(entry.uniform()).isEmpty());
    if (shown.isEmpty()) {
      return Optional.empty();
    }
    int columns = Math.min(COLUMNS, shown.size());
    int rows = (shown.size() - 1) / columns + 1;
    int width = Math.max(columns * Panel.WIDTH, LEGEND_WIDTH);
    Svg svg = new Svg(width, LEGEND + rows * Panel.HEIGHT);
    legend(svg, cost);
    for (int i = 0; i < shown.size(); i++) {
      Report.Entry entry = shown.get(i);
      svg.group(i % columns * Panel.WIDTH, LEGEND + i / columns * Panel.HEIGHT);
      new Panel(svg, entry.uniform(), entry.targets().runs(), cost)
          .draw(entry.name(), entry.uniform());
      svg.endGroup();
    }
    return Optional.of(svg.end());
  }

  private static void legend(Svg svg, Cost cost) {
    String across = cost == Cost.SECONDS ? "wall seconds of tracing" : "rays of all kinds";
    String title = "RMS error in display levels (up) against " + across;
    svg.text(12, 18, "start", Panel.DARK, title);
    svg.group(12, 36);
    svg.dot(4, 0, Panel.MEASURED, true);
    svg.text(14, 4, "start", Panel.DARK, "error of uniform sampling");
    svg.dot(180, 0, Panel.MEASURED, false);
    svg.text(190, 4, "start", Panel.DARK, "truth too coarse to tell");
    svg.line(332, 0, 356, 0, Panel.FITTED, Panel.FITTED_DASHES);
    svg.text(362, 4, "start", Panel.DARK, "fitted slope");
    svg.line(448, 0, 472, 0, Panel.RANDOM, Panel.RANDOM_DASHES);
    svg.text(478, 4, "start", Panel.DARK, "slope -1/2");
    svg.diamond(556, 0, Panel.FITTED);
    svg.text(566, 4, "start", Panel.DARK, "rendered to 4, 2, 1, 0.5 levels");
    svg.endGroup();
  }
}
