package glint.desktop.window;

import glint.report.Measurement;
import glint.report.Measurement.Cost;
import glint.report.TargetRuns;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Draws what a run has measured: error against seconds. */
final class SpeedChart {

  private static final Color UNIFORM = new Color(0x2c8ac9);
  private static final Color TARGETS = new Color(0xd55e00);

  /** Smaller errors are not told apart. */
  private static final double LEAST = 0.01;

  private SpeedChart() {}

  /** Returns the chart; empty series where there is no error to draw. */
  static ChartView of(SpeedRun.Result found) {
    XYChart chart = new XYChartBuilder().xAxisTitle("seconds").yAxisTitle("error, levels").build();
    chart.getStyler().setXAxisLogarithmic(true).setYAxisLogarithmic(true);
    decades(chart.getStyler(), found);
    chart.getStyler().setPlotGridLinesVisible(false);
    chart.getStyler().setLegendVisible(true);
    List<Measurement> points =
        found.uniform().points().stream().filter(p -> p.error().levels() > LEAST).toList();
    add(
        chart,
        "uniform",
        points.stream().map(p -> p.cost(Cost.SECONDS)).toList(),
        points.stream().map(p -> p.error().levels()).toList(),
        UNIFORM,
        SeriesMarkers.CIRCLE);
    List<TargetRuns> targets =
        found.targets().runs().stream().filter(r -> r.error().levels() > LEAST).toList();
    add(
        chart,
        "to an error",
        targets.stream().map(r -> r.cost(Cost.SECONDS)).toList(),
        targets.stream().map(r -> r.error().levels()).toList(),
        TARGETS,
        SeriesMarkers.DIAMOND);
    ChartView view = new ChartView("Error against seconds", chart);
    view.setPreferredSize(new Dimension(260, 240));
    return view;
  }

  /** Has both axes begin and end with a power of ten. */
  private static void decades(XYStyler styler, SpeedRun.Result found) {
    DoubleSummaryStatistics x = new DoubleSummaryStatistics();
    DoubleSummaryStatistics y = new DoubleSummaryStatistics();
    for (Measurement point : found.uniform().points()) {
      x.accept(point.cost(Cost.SECONDS));
      y.accept(Math.max(LEAST, point.error().levels()));
    }
    for (TargetRuns runs : found.targets().runs()) {
      x.accept(runs.cost(Cost.SECONDS));
      y.accept(Math.max(LEAST, runs.error().levels()));
    }
    styler.setXAxisMin(below(x.getMin())).setXAxisMax(above(x.getMax()));
    styler.setYAxisMin(below(y.getMin())).setYAxisMax(above(y.getMax()));
  }

  private static double below(double value) {
    return Math.pow(10, Math.floor(Math.log10(value)));
  }

  private static double above(double value) {
    return Math.pow(10, Math.ceil(Math.log10(value)));
  }

  private static void add(
      XYChart chart, String name, List<Double> x, List<Double> y, Color colour, Marker marker) {
    if (x.isEmpty()) {
      return;
    }
    XYSeries series = chart.addSeries(name, x, y);
    series.setMarker(marker);
    series.setMarkerColor(colour);
    series.setLineColor(colour);
    series.setLineStyle(marker == SeriesMarkers.CIRCLE ? new BasicStroke(1) : SeriesLines.NONE);
  }
}
