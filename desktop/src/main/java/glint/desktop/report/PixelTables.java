package glint.desktop.report;

import glint.report.Curve;
import glint.report.DepthStudy;
import glint.report.TargetStudy;
import glint.report.ThinLines;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Tables of what single pixels and bounces do. */
final class PixelTables {

  private PixelTables() {}

  /** The pixels of a scene that are off most, with the commands that show them. */
  static Block.Grid worst(Report.Entry entry) {
    List<List<String>> rows = new ArrayList<>();
    List<TargetStudy.Worst> worst = entry.targets().worst();
    for (int i = 0; i < worst.size(); i++) {
      TargetStudy.Worst each = worst.get(i);
      rows.add(
          List.of(
              "`" + entry.replays().get(i) + "`",
              Numbers.digits(each.actual()),
              each.claimed() > Curve.NONE ? Numbers.digits(each.claimed()) : "0",
              String.valueOf(each.samples())));
    }
    return new Block.Grid(List.of("pixel", "off by", "claimed", "camera rays"), rows);
  }

  /** How many pixels show nothing of a line that crosses them. */
  static Block.Grid lines(Report report) {
    List<List<String>> rows = new ArrayList<>();
    for (ThinLines.Count each : report.lines()) {
      rows.add(
          List.of(
              String.valueOf(each.width()),
              String.valueOf(each.crossed()),
              String.valueOf(each.missed()),
              String.format(Locale.ROOT, "%.2f %%", 100.0 * each.missed() / each.crossed())));
    }
    return new Block.Grid(List.of("pixels wide", "crossed", "missed", "share"), rows);
  }

  /** What is lost with fewer bounces, and what share of the time they take. */
  static Block.Grid depths(Report report) {
    int most = 0;
    for (Report.Entry entry : report.entries()) {
      most = Math.max(most, entry.depths().points().size());
    }
    List<String> head = new ArrayList<>(List.of("scene", "all", "seconds", "rays"));
    for (int i = 0; i + 1 < most; i++) {
      head.add(i == 0 ? "0 bounces" : String.valueOf(1 << i - 1));
    }
    List<List<String>> rows = new ArrayList<>();
    for (Report.Entry entry : report.entries()) {
      List<DepthStudy.Point> points = entry.depths().points();
      if (points.size() > 1) {
        rows.add(depths(entry.name(), points, most));
      }
    }
    return new Block.Grid(head, rows);
  }

  private static List<String> depths(String name, List<DepthStudy.Point> points, int most) {
    DepthStudy.Point all = points.get(points.size() - 1);
    List<String> row = new ArrayList<>();
    row.add(name);
    row.add(String.valueOf(all.depth()));
    row.add(Numbers.prefixed(all.seconds(), "s"));
    row.add(Numbers.prefixed((double) all.rays(), ""));
    for (int i = 0; i + 1 < most; i++) {
      boolean there = i + 1 < points.size();
      row.add(there ? lost(points.get(i), all) : "–");
    }
    return row;
  }

  private static String lost(DepthStudy.Point point, DepthStudy.Point all) {
    String error = point.error() > Curve.NONE ? Numbers.digits(point.error()) : "0";
    double share = 100 * point.seconds() / all.seconds();
    return error + String.format(Locale.ROOT, " at %.0f %%", share);
  }
}
