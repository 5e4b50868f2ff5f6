package glint.desktop.window;

import java.awt.BasicStroke;
import java.awt.BorderLayout;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The error that is claimed for a render, against time, as it comes down. */
final class ErrorChart extends JPanel {

  private static final long serialVersionUID = 1;

  private static final String CLAIMED = "claimed";
  private static final String GOAL = "goal";

  private final transient XYChart chart =
      new XYChartBuilder().xAxisTitle("seconds").yAxisTitle("error, levels").build();
  private final transient XYSeries claimed;
  private final ChartView view;
  private double last;
  private final List<Double> seconds = new ArrayList<>();
  private final List<Double> errors = new ArrayList<>();

  /** Makes an empty chart. */
  ErrorChart() {
    super(new BorderLayout());
    chart.getStyler().setYAxisLogarithmic(true);
    chart.getStyler().setLegendVisible(false);
    chart.getStyler().setXAxisMin(0.0);
    chart.getStyler().setYAxisMin(0.1);
    chart.getStyler().setPlotGridHorizontalLinesVisible(false);
    XYSeries goal = chart.addSeries(GOAL, new double[] {0, 1}, new double[] {1, 1});
    goal.setMarker(SeriesMarkers.NONE);
    goal.setLineColor(new Color(0xd55e00));
    goal.setLineStyle(new BasicStroke(1, 0, 0, 1, new float[] {5, 3}, 0));
    claimed = chart.addSeries(CLAIMED, new double[] {0}, new double[] {100});
    claimed.setMarker(SeriesMarkers.CIRCLE);
    claimed.setMarkerColor(new Color(0x2c8ac9));
    claimed.setLineColor(new Color(0x2c8ac9));
    view = new ChartView("Claimed error against time", chart);
    add(view, BorderLayout.CENTER);
    draw();
  }

  /** Shows where a render stands; one that is younger than the one before is another. */
  void show(Snapshot s) {
    if (s.seconds() < last) {
      seconds.clear();
      errors.clear();
      draw();
    }
    last = s.seconds();
    boolean known = s.error() > 0 && s.error() < Double.POSITIVE_INFINITY;
    if (!known || (!errors.isEmpty() && errors.get(errors.size() - 1) == s.error())) {
      return;
    }
    seconds.add(s.seconds());
    errors.add(s.error());
    draw();
  }

  private void draw() {
    boolean any = !errors.isEmpty();
    double end = any ? seconds.get(seconds.size() - 1) : 1;
    double top = errors.stream().mapToDouble(e -> e).max().orElse(1);
    chart.getStyler().setYAxisMax(Math.pow(10, Math.max(1, Math.ceil(Math.log10(top)))));
    chart.updateXYSeries(GOAL, new double[] {0, end}, new double[] {1, 1}, null);
    if (any) {
      chart.updateXYSeries(CLAIMED, seconds, errors, null);
    }
    claimed.setEnabled(any);
    view.repaint();
  }
}
