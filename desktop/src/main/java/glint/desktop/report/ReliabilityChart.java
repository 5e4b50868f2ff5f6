package glint.desktop.report;

import glint.report.Calibration;
import glint.report.Honesty;
import glint.report.TargetRuns;
import java.util.ArrayList;
import java.util.List;

/**
 * Draws true errors against claimed ones as SVG: on the left every image, on the right the pixels
 * of each scene in bins of growing claims. What is right lies on the diagonal, what is too careful
 * below it.
 */
final class ReliabilityChart {

  private static final int EDGE = 320;
  private static final int LEFT = 52;
  private static final int TOP = 44;
  private static final int WIDTH = 860;
  private static final int GAP = 420;

  /** What lies outside is drawn at the border. */
  private static final LogAxis IMAGES = new LogAxis(-2, 1, power -> "");

  private static final LogAxis PIXELS = new LogAxis(-3, 2, power -> "");

  private record Dot(double claimed, double actual) {}

  private ReliabilityChart() {}

  /** Returns the chart. */
  static String of(Report report) {
    List<Dot> images = new ArrayList<>();
    List<Dot> pixels = new ArrayList<>();
    for (Report.Entry entry : report.entries()) {
      for (TargetRuns runs : entry.targets().runs()) {
        for (Honesty.Claim claim : runs.claims()) {
          images.add(new Dot(claim.claimed(), claim.actual()));
        }
      }
      Calibration c = Calibration.of(entry.targets().claimed(), entry.targets().actual(), 1);
      c.reliability().forEach(bin -> pixels.add(new Dot(bin.claimed(), bin.actual())));
    }
    Svg svg = new Svg(WIDTH, TOP + EDGE + 52);
    panel(svg, 0, "every image", IMAGES, images);
    panel(svg, GAP, "pixels of each scene, in ten bins", PIXELS, pixels);
    return svg.end();
  }

  private static void panel(Svg svg, int right, String title, LogAxis axis, List<Dot> dots) {
    svg.group(right + LEFT, TOP);
    svg.text(0, -24, "start", Panel.DARK, title);
    svg.text(0, -8, "start", Panel.GREY, "true error (up) against claimed, in levels");
    for (int power = axis.low(); power <= axis.high(); power++) {
      double at = EDGE * axis.place(Math.pow(10, power));
      svg.line(at, 0, at, EDGE, Panel.PALE, "none");
      svg.line(0, EDGE - at, EDGE, EDGE - at, Panel.PALE, "none");
      svg.text(at, EDGE + 16, "middle", Panel.GREY, Panel.plain(power));
      svg.text(-6, EDGE - at + 4, "end", Panel.GREY, Panel.plain(power));
    }
    svg.line(0, EDGE, EDGE, 0, Panel.FITTED, Panel.FITTED_DASHES);
    for (Dot dot : dots) {
      if (Math.max(dot.claimed, dot.actual) > Math.pow(10, axis.low())) {
        svg.speck(EDGE * place(axis, dot.claimed), EDGE - EDGE * place(axis, dot.actual));
      }
    }
    svg.endGroup();
  }

  private static double place(LogAxis axis, double value) {
    double least = Math.pow(10, axis.low());
    return Math.min(1, axis.place(Math.max(value, least)));
  }
}
