package glint.desktop.window;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JPanel;
import javax.swing.UIManager;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.XYStyler;

/** Shows a chart in the colours of the window. */
final class ChartView extends JPanel {

  private static final long serialVersionUID = 1;

  private final transient XYChart chart;

  /**
   * Makes a view.
   *
   * @param name what it shows
   */
  ChartView(String name, XYChart chart) {
    this.chart = chart;
    setName(name);
    setToolTipText(name);
    getAccessibleContext().setAccessibleName(name);
    setPreferredSize(new Dimension(260, 180));
    setMinimumSize(new Dimension(120, 100));
    style();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (chart != null) {
      style();
    }
  }

  private void style() {
    XYStyler styler = chart.getStyler();
    Color back = UIManager.getColor("Panel.background");
    Color text = UIManager.getColor("Label.foreground");
    Color lines = UIManager.getColor("Separator.foreground");
    Font font = UIManager.getFont("Label.font").deriveFont(11f);
    styler.setChartBackgroundColor(back);
    styler.setPlotBackgroundColor(back);
    styler.setPlotBorderVisible(false);
    styler.setChartFontColor(text);
    styler.setAxisTickLabelsColor(text);
    styler.setAxisTickMarksColor(lines);
    styler.setPlotGridLinesColor(lines);
    styler.setXAxisTitleColor(text);
    styler.setYAxisTitleColor(text);
    styler.setAxisTickLabelsFont(font);
    styler.setAxisTitleFont(font);
    styler.setLegendFont(font);
    styler.setLegendBackgroundColor(back);
    styler.setLegendBorderColor(back);
    styler.setLegendPosition(Styler.LegendPosition.InsideNE);
    styler.setChartTitleVisible(false);
    styler.setChartPadding(4);
    styler.setMarkerSize(5);
    repaint();
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D g = (Graphics2D) graphics.create();
    chart.paint(g, getWidth(), getHeight());
    g.dispose();
  }
}
