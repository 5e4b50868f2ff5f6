package glint.desktop.report;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import glint.report.Curve;
import glint.report.Errors;
import glint.report.Measurement;
import glint.report.Measurement.Cost;
import glint.report.Rays;
import glint.report.Spread;
import java.util.List;

/** A report in the form of its JSON; the names are a contract with scripts. */
record ReportJson(String command, Report.Environment environment, List<SceneRow> scenes) {

  private static final Gson GSON =
      new GsonBuilder().serializeNulls().disableHtmlEscaping().setPrettyPrinting().create();

  /** One scene. */
  record SceneRow(String name, String file, int width, int height, Truth truth, Uniform uniform) {}

  /** What was compared with; the uncertainty is in display levels. */
  record Truth(String origin, double uncertainty) {}

  /** As many samples for every pixel; a slope is null where the points do not tell it. */
  record Uniform(
      List<Point> points, Slope raySlope, Slope secondSlope, double truncation, boolean complete) {}

  /** The slope of error against a cost, and its interval of 95 %. */
  record Slope(double value, double low, double high) {}

  /** One number of samples; {@code runs} are the errors of single runs, in display levels. */
  record Point(
      int samples, Errors error, boolean trusted, Spread seconds, Rays rays, List<Double> runs) {}

  /** Returns the text of a report. */
  static String of(Report report) {
    List<SceneRow> scenes = report.entries().stream().map(ReportJson::scene).toList();
    return GSON.toJson(new ReportJson(report.command(), report.environment(), scenes)) + "\n";
  }

  private static SceneRow scene(Report.Entry entry) {
    Curve curve = entry.uniform();
    Truth truth = new Truth(curve.truth().origin(), curve.truth().uncertainty());
    Uniform uniform =
        new Uniform(
            curve.points().stream().map(ReportJson::point).toList(),
            slope(curve, Cost.RAYS),
            slope(curve, Cost.SECONDS),
            curve.truncation(),
            curve.complete());
    return new SceneRow(entry.name(), entry.file(), entry.width(), entry.height(), truth, uniform);
  }

  private static Slope slope(Curve curve, Cost cost) {
    return curve
        .trend(cost)
        .map(t -> new Slope(t.law().slope(), t.interval().low(), t.interval().high()))
        .orElse(null);
  }

  private static Point point(Measurement m) {
    List<Double> runs = m.runs().stream().map(Errors::levels).toList();
    return new Point(m.samples(), m.error(), m.trusted(), m.seconds(), m.rays(), runs);
  }
}
