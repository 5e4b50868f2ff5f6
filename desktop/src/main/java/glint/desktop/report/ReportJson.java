package glint.desktop.report;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonPrimitive;
import com.google.gson.JsonSerializationContext;
import com.google.gson.JsonSerializer;
import glint.report.Calibration;
import glint.report.Curve;
import glint.report.DepthStudy;
import glint.report.Errors;
import glint.report.Measurement;
import glint.report.Measurement.Cost;
import glint.report.Rays;
import glint.report.Spread;
import glint.report.TargetRuns;
import glint.report.TargetStudy;
import glint.report.ThinLines;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.List;

/** A report in the form of its JSON; the names are a contract with scripts. */
record ReportJson(
    String command,
    Report.Environment environment,
    List<SceneRow> scenes,
    List<ThinLines.Count> thinLines) {

  private static final Gson GSON =
      new GsonBuilder()
          .serializeNulls()
          .disableHtmlEscaping()
          .setPrettyPrinting()
          .registerTypeAdapter(double.class, (JsonSerializer<Double>) ReportJson::figure)
          .registerTypeAdapter(Double.class, (JsonSerializer<Double>) ReportJson::figure)
          .create();

  /** One scene. */
  record SceneRow(
      String name,
      String file,
      int width,
      int height,
      Truth truth,
      Uniform uniform,
      List<TargetRuns> targets,
      Calibration pixels,
      List<DepthStudy.Point> depths,
      List<Worst> worst) {}

  /** What was compared with; how far that may be off and how far a formula is, in levels. */
  record Truth(String origin, double uncertainty, Double formula) {}

  /** A pixel that is off, and the command that shows it. */
  record Worst(TargetStudy.Worst pixel, String replay) {}

  /** As many samples for every pixel; a slope is null where the points do not tell it. */
  record Uniform(
      List<Point> points, Slope raySlope, Slope secondSlope, double truncation, boolean complete) {}

  /** The slope of error against a cost, and its interval of 95 %. */
  record Slope(double value, double low, double high) {}

  /** One number of samples; {@code runs} are the errors of single runs, in display levels. */
  record Point(
      int samples, Errors error, boolean trusted, Spread seconds, Rays rays, List<Double> runs) {}

  /** JSON has no figures that are not finite. */
  private static JsonElement figure(Double value, Type type, JsonSerializationContext context) {
    return Double.isFinite(value) ? new JsonPrimitive(value) : JsonNull.INSTANCE;
  }

  /** Returns the text of a report. */
  static String of(Report report) {
    List<SceneRow> scenes = report.entries().stream().map(ReportJson::scene).toList();
    ReportJson json =
        new ReportJson(report.command(), report.environment(), scenes, report.lines());
    return GSON.toJson(json) + "\n";
  }

  private static SceneRow scene(Report.Entry entry) {
    Curve curve = entry.uniform();
    Truth truth =
        new Truth(
            curve.truth().origin(),
            curve.truth().uncertainty(),
            entry.formula().isPresent() ? entry.formula().getAsDouble() : null);
    Uniform uniform =
        new Uniform(
            curve.points().stream().map(ReportJson::point).toList(),
            slope(curve, Cost.RAYS),
            slope(curve, Cost.SECONDS),
            curve.truncation(),
            curve.complete());
    TargetStudy targets = entry.targets();
    List<Worst> worst = new ArrayList<>();
    for (int i = 0; i < targets.worst().size(); i++) {
      worst.add(new Worst(targets.worst().get(i), entry.replays().get(i)));
    }
    return new SceneRow(
        entry.name(),
        entry.file(),
        entry.width(),
        entry.height(),
        truth,
        uniform,
        targets.runs(),
        Calibration.of(targets.claimed(), targets.actual(), TargetTables.SILENT),
        entry.depths().points(),
        worst);
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
