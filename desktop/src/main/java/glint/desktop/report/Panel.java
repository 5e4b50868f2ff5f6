package glint.desktop.report;

import glint.report.Curve;
import glint.report.Measurement;
import glint.report.Measurement.Cost;
import glint.report.PowerLaw;
import glint.report.TargetRuns;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

/** A small chart: the error of one scene against its cost, on axes of its own. */
final class Panel {

  static final int WIDTH = 300;
  static final int HEIGHT = 236;
  static final String MEASURED = "#0072b2";
  static final String FITTED = "#d55e00";
  static final String FITTED_DASHES = "5 3";
  static final String RANDOM = "#999";
  static final String RANDOM_DASHES = "1 3";
  static final String DARK = "#222";

  static final String GREY = "#777";
  static final String PALE = "#e4e4e4";

  /** The axes: left end, right end, top, bottom. */
  private static final int X0 = 58;

  private static final int X1 = 276;
  private static final int Y0 = 40;
  private static final int Y1 = 196;

  /** Labels closer than this would touch. */
  private static final int LABEL_WIDTH = 44;

  private static final int LABEL_HEIGHT = 14;

  /** The longest name that fits above the axes. */
  private static final int NAME = 34;

  private final Svg svg;
  private final Cost cost;
  private final List<Measurement> points;
  private final List<TargetRuns> targets;
  private final LogAxis x;
  private final LogAxis y;

  /** Sets up the chart of a curve that has at least one point to draw. */
  Panel(Svg svg, Curve curve, List<TargetRuns> targets, Cost cost) {
    this.svg = svg;
    this.cost = cost;
    points = drawn(curve);
    this.targets = targets.stream().filter(runs -> runs.error().levels() > Curve.NONE).toList();
    String unit = cost == Cost.SECONDS ? "s" : "";
    x =
        axis(
            point -> point.cost(cost),
            runs -> runs.cost(cost),
            power -> Numbers.prefixed(Math.pow(10, power), unit));
    y = axis(Panel::error, runs -> runs.error().levels(), Panel::plain);
  }

  /** Returns the points that a logarithmic axis can show. */
  static List<Measurement> drawn(Curve curve) {
    return curve.points().stream()
        .filter(point -> error(point) > Curve.NONE)
        .collect(Collectors.toList());
  }

  /** Draws it. */
  void draw(String name, Curve curve) {
    String title = name.length() > NAME ? name.substring(0, NAME) + "…" : name;
    svg.text(X0, 16, "start", DARK, title);
    svg.text(X0, 31, "start", GREY, subtitle(curve));
    grid();
    // Two samples are the first that a random sampler would place as well.
    Measurement second = points.get(Math.min(1, points.size() - 1));
    double factor = error(second) * Math.sqrt(second.cost(cost));
    line(new PowerLaw(factor, -0.5), RANDOM, RANDOM_DASHES);
    curve.trend(cost).ifPresent(trend -> line(trend.law(), FITTED, FITTED_DASHES));
    for (Measurement point : points) {
      svg.dot(px(point.cost(cost)), py(error(point)), MEASURED, point.trusted());
    }
    for (TargetRuns runs : targets) {
      svg.diamond(px(runs.cost(cost)), py(runs.error().levels()), FITTED);
    }
  }

  private LogAxis axis(
      ToDoubleFunction<Measurement> value,
      ToDoubleFunction<TargetRuns> other,
      IntFunction<String> words) {
    DoubleSummaryStatistics range = points.stream().mapToDouble(value).summaryStatistics();
    range.combine(targets.stream().mapToDouble(other).summaryStatistics());
    return LogAxis.around(range.getMin(), range.getMax(), words);
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
      svg.line(at, Y0, at, Y1, PALE, "none");
      if ((power - x.low()) % stepX == 0) {
        svg.text(at, Y1 + 14, "middle", GREY, x.words().apply(power));
      }
    }
    int stepY = step(y, Y1 - Y0, LABEL_HEIGHT);
    for (int power = y.low(); power <= y.high(); power++) {
      double at = py(Math.pow(10, power));
      svg.line(X0, at, X1, at, PALE, "none");
      if ((power - y.low()) % stepY == 0) {
        svg.text(X0 - 5, at + 4, "end", GREY, y.words().apply(power));
      }
    }
  }

  /** Returns every how many decades there is room for a label. */
  private static int step(LogAxis axis, int length, int label) {
    int decades = axis.high() - axis.low();
    return Math.max(1, (int) Math.ceil((double) label * decades / length));
  }

  /** Draws a law from the first point to the last, as far as the axes reach. */
  private void line(PowerLaw law, String colour, String dashes) {
    double from = points.get(0).cost(cost);
    double to = points.get(points.size() - 1).cost(cost);
    double top = Math.pow(10, y.high());
    double bottom = Math.pow(10, y.low());
    double a = Math.max(from, Math.min(law.inverse(top), law.inverse(bottom)));
    double b = Math.min(to, Math.max(law.inverse(top), law.inverse(bottom)));
    if (a < b) {
      svg.line(px(a), py(law.at(a)), px(b), py(law.at(b)), colour, dashes);
    }
  }

  private double px(double value) {
    return X0 + (X1 - X0) * x.place(value);
  }

  private double py(double value) {
    return Y1 - (Y1 - Y0) * y.place(value);
  }

  private static double error(Measurement point) {
    return point.error().levels();
  }

  static String plain(int power) {
    return power < 0 ? "0." + "0".repeat(-power - 1) + "1" : "1" + "0".repeat(power);
  }
}
