package glint.desktop.report;

import glint.report.Curve;
import glint.report.Measurement;
import glint.report.Measurement.Cost;
import glint.report.PowerLaw;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/** Draws error against cost as SVG: one small chart for each scene, all with the same axes. */
final class PanelChart {

  private static final int COLUMNS = 3;
  private static final int WIDTH = 300;
  private static final int HEIGHT = 236;
  private static final int LEGEND = 52;

  /** The axes within a panel: left end, right end, top, bottom. */
  private static final int X0 = 58;

  private static final int X1 = 276;
  private static final int Y0 = 40;
  private static final int Y1 = 196;

  /** Labels closer than this would touch. */
  private static final int LABEL_WIDTH = 44;

  private static final int LABEL_HEIGHT = 14;

  private final Cost cost;
  private final LogAxis x;
  private final LogAxis y;
  private final StringBuilder out = new StringBuilder();

  private PanelChart(List<Report.Entry> entries, Cost cost) {
    this.cost = cost;
    IntFunction<String> words = power -> Numbers.prefixed(Math.pow(10, power), unit());
    x = axis(entries, point -> point.cost(cost), words);
    y = axis(entries, PanelChart::error, PanelChart::plain);
  }

  /** Returns the chart of all scenes that have an error to draw; nothing if none has. */
  static Optional<String> of(List<Report.Entry> entries, Cost cost) {
    List<Report.Entry> shown = new ArrayList<>(entries);
    shown.removeIf(entry -> drawn(entry.uniform()).findAny().isEmpty());
    return shown.isEmpty()
        ? Optional.empty()
        : Optional.of(new PanelChart(shown, cost).draw(shown));
  }

  private static LogAxis axis(
      List<Report.Entry> entries, ToDoubleFunction<Measurement> value, IntFunction<String> words) {
    DoubleSummaryStatistics range =
        entries.stream()
            .flatMap(entry -> drawn(entry.uniform()))
            .mapToDouble(value)
            .summaryStatistics();
    return LogAxis.around(range.getMin(), range.getMax(), words);
  }

  /** Returns the points that a logarithmic axis can show. */
  private static Stream<Measurement> drawn(Curve curve) {
    return curve.points().stream().filter(point -> error(point) > Curve.NONE);
  }

  private static double error(Measurement point) {
    return point.error().levels();
  }

  private static String plain(int power) {
    return power < 0 ? "0." + "0".repeat(-power - 1) + "1" : "1" + "0".repeat(power);
  }

  private String unit() {
    return cost == Cost.SECONDS ? "s" : "";
  }

  private String draw(List<Report.Entry> entries) {
    int columns = Math.min(COLUMNS, entries.size());
    int rows = (entries.size() - 1) / columns + 1;
    int width = Math.max(columns, 2) * WIDTH;
    int height = LEGEND + rows * HEIGHT;
    add(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\""
            + " height=\"%d\" font-family=\"sans-serif\" font-size=\"11\">",
        width, height, width, height);
    add("<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>", width, height);
    legend();
    for (int i = 0; i < entries.size(); i++) {
      int left = i % columns * WIDTH;
      add("<g transform=\"translate(%d %d)\">", left, LEGEND + i / columns * HEIGHT);
      panel(entries.get(i));
      add("</g>");
    }
    add("</svg>");
    return out.toString();
  }

  private void legend() {
    String across = cost == Cost.SECONDS ? "wall seconds of tracing" : "rays of all kinds";
    text(12, 18, "start", "#222", "RMS error in display levels (up) against " + across);
    add("<g transform=\"translate(12 36)\">");
    dot(4, 0, true);
    text(14, 4, "start", "#222", "error of uniform sampling");
    dot(180, 0, false);
    text(190, 4, "start", "#222", "truth too coarse to tell");
    add("<path d=\"M332 0h24\" stroke=\"#d55e00\" stroke-dasharray=\"5 3\"/>");
    text(362, 4, "start", "#222", "fitted slope");
    add("<path d=\"M448 0h24\" stroke=\"#999\" stroke-dasharray=\"1 3\"/>");
    text(478, 4, "start", "#222", "slope -1/2");
    add("</g>");
  }

  private void panel(Report.Entry entry) {
    text(X0, 16, "start", "#222", entry.name());
    text(X0, 31, "start", "#777", subtitle(entry.uniform()));
    grid();
    List<Measurement> points = new ArrayList<>();
    drawn(entry.uniform()).forEach(points::add);
    // Two samples are the first that a random sampler would place as well
    Measurement second = points.get(Math.min(1, points.size() - 1));
    double factor = error(second) * Math.sqrt(second.cost(cost));
    line(new PowerLaw(factor, -0.5), points, "#999", "1 3");
    entry.uniform().trend(cost).ifPresent(trend -> line(trend.law(), points, "#d55e00", "5 3"));
    for (Measurement point : points) {
      dot(px(point.cost(cost)), py(error(point)), point.trusted());
    }
  }

  private String subtitle(Curve curve) {
    String slope =
        curve
            .trend(cost)
            .map(trend -> String.format(Locale.ROOT, ", slope %.2f", trend.law().slope()))
            .orElse("");
    return curve.truth().origin() + slope;
  }

  private void grid() {
    int stepX = step(x, X1 - X0, LABEL_WIDTH);
    for (int power = x.low(); power <= x.high(); power++) {
      double at = px(Math.pow(10, power));
      add("<path d=\"M%.1f %dV%d\" stroke=\"#e4e4e4\"/>", at, Y0, Y1);
      if ((power - x.low()) % stepX == 0) {
        text(at, Y1 + 14, "middle", "#555", x.words().apply(power));
      }
    }
    int stepY = step(y, Y1 - Y0, LABEL_HEIGHT);
    for (int power = y.low(); power <= y.high(); power++) {
      double at = py(Math.pow(10, power));
      add("<path d=\"M%d %.1fH%d\" stroke=\"#e4e4e4\"/>", X0, at, X1);
      if ((power - y.low()) % stepY == 0) {
        text(X0 - 5, at + 4, "end", "#555", y.words().apply(power));
      }
    }
  }

  /** Returns every how many decades there is room for a label. */
  private static int step(LogAxis axis, int length, int label) {
    int decades = axis.high() - axis.low();
    return Math.max(1, (int) Math.ceil((double) label * decades / length));
  }

  /** Draws a straight line over the points, as far as the axes reach. */
  private void line(PowerLaw law, List<Measurement> points, String colour, String dashes) {
    List<String> places = new ArrayList<>();
    for (Measurement point : points) {
      double at = point.cost(cost);
      if (y.holds(law.at(at))) {
        places.add(String.format(Locale.ROOT, "%.1f,%.1f", px(at), py(law.at(at))));
      }
    }
    add(
        "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-dasharray=\"%s\"/>",
        String.join(" ", places), colour, dashes);
  }

  private void dot(double atX, double atY, boolean full) {
    String fill = full ? "#0072b2" : "#fff";
    add("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" stroke=\"#0072b2\"/>", atX, atY, fill);
  }

  private void text(double atX, double atY, String anchor, String colour, String words) {
    add(
        "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>",
        atX, atY, anchor, colour, Html.escape(words));
  }

  private double px(double value) {
    return X0 + (X1 - X0) * x.place(value);
  }

  private double py(double value) {
    return Y1 - (Y1 - Y0) * y.place(value);
  }

  private void add(String format, Object... values) {
    out.append(String.format(Locale.ROOT, format, values)).append('\n');
  }
}
