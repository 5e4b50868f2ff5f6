package glint.desktop.report;

import glint.report.Curve;
import glint.report.Errors;
import glint.report.Measurement;
import glint.report.Measurement.Cost;
import glint.report.Rays;
import glint.report.Spread;
import glint.report.Study;
import glint.report.TargetStudy;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Puts a report into words, tables and charts. */
final class ReportPage {

  private static final String EQUAL =
      "A render to an error of one level, and uniform sampling with as many samples as have the same"
          + " true error: between powers of two by a power law, beyond those that were measured by"
          + " that of the last doubling. How many times faster it is, and with how many times fewer"
          + " rays, is the ratio of efficiencies at that error, with its 95 % bootstrap interval over"
          + " the runs of both. Means are geometric, over images of 1024 pixels and more. Other"
          + " targets are among all figures.";

  private static final String HONEST =
      "Of each scene and target there are "
          + TargetStudy.RUNS
          + " images with different seeds. Kept is the share of them whose true error is at most"
          + " the target; true over claimed is the median, over claims of at least 0.05 levels."
          + " Pixels are those of one image at a target of one level: σ is what a pixel claims, and"
          + " a pixel is silent that claims less than 4 levels and is off by more; ranks stand for"
          + " Spearman's correlation of claims and truth. Pixels without"
          + " any error, claimed or true, are left out.";

  private static final String BOUNCES =
      "What is lost with fewer bounces, in levels, at what share of the time that all take; with 4"
          + " samples for every pixel, compared with the same samples and all bounces.";

  private static final String WORST =
      "The ten pixels of the image at a target of one level that are off most, and the commands that"
          + " show all their rays.";

  private static final String LINES =
      "Bright lines thinner than a pixel, of all directions, made as quads, cylinders and meshes,"
          + " and rendered to one level: missed is a pixel that one crosses and that shows nothing of"
          + " it. They are in none of the scenes above.";

  private final Report report;
  private final String files;
  private final List<Block> page = new ArrayList<>();

  private ReportPage(Report report, String files) {
    this.report = report;
    this.files = files;
  }

  /**
   * Returns the page.
   *
   * @param files what the names of the charts' files begin with
   */
  static List<Block> of(Report report, String files) {
    return new ReportPage(report, files).page();
  }

  private List<Block> page() {
    page.add(new Block.Heading(1, "Speed against error"));
    page.add(new Block.Paragraph(machine()));
    explain();
    page.add(new Block.Heading(2, "At equal error"));
    page.add(new Block.Paragraph(EQUAL));
    page.add(TargetTables.equalError(report));
    page.add(new Block.Heading(2, "At equal time"));
    page.add(TargetTables.equalTime(report));
    page.add(new Block.Heading(2, "Honesty"));
    page.add(new Block.Paragraph(HONEST));
    page.add(TargetTables.honesty(report));
    String reliability = ReliabilityChart.of(report);
    page.add(
        new Block.Figure(
            files + "-reliability.svg",
            "True errors against claims; what lies outside stands at the border",
            reliability));
    page.add(TargetTables.calibration(report));
    page.add(new Block.Heading(2, "As many samples for every pixel"));
    page.add(errors());
    chart(Cost.SECONDS, "seconds", "Error against seconds");
    chart(Cost.RAYS, "rays", "Error against rays");
    page.add(new Block.Heading(2, "Cost"));
    page.add(costs());
    page.add(new Block.Heading(2, "Bounces"));
    page.add(new Block.Paragraph(BOUNCES));
    page.add(PixelTables.depths(report));
    page.add(new Block.Heading(2, "Worst pixels"));
    page.add(new Block.Paragraph(WORST));
    for (Report.Entry entry : report.entries()) {
      if (!entry.targets().worst().isEmpty()) {
        page.add(new Block.Details(entry.name(), PixelTables.worst(entry)));
      }
    }
    page.add(new Block.Heading(2, "Thin lines"));
    page.add(new Block.Paragraph(LINES));
    page.add(PixelTables.lines(report));
    page.add(new Block.Heading(2, "All figures"));
    for (Report.Entry entry : report.entries()) {
      page.add(new Block.Details(summary(entry), figures(entry.uniform())));
      page.add(
          new Block.Details(
              entry.name() + ", rendered to an error", TargetTables.equalError(entry)));
    }
    return page;
  }

  private String machine() {
    Report.Environment e = report.environment();
    String commit = e.commit().isEmpty() ? "" : ", commit " + e.commit();
    return String.format(
        Locale.ROOT,
        "Made by `%s`: Glint %s%s, %s, %s, %s.",
        report.command(),
        e.version(),
        commit,
        e.java(),
        e.machine(),
        e.threads() == 1 ? "1 thread" : e.threads() + " threads");
  }

  private void explain() {
    page.add(
        new Block.Paragraph(
            "The error is the root mean square of the differences to the truth over all channels,"
                + " in display levels: 255·encode(clamp(x, 0, 1)), unrounded. The truth is what"
                + " the scene file says that follows from a formula, pixels or the mean of the"
                + " image; without that it is a reference, the mean of two long runs that share no"
                + " sample and go on in every pixel until they agree. Half of what they differ by is"
                + " how far the reference may be off; where a formula says more of the picture, the"
                + " reference is that far from it. An"
                + " error less than ten times as large stands in parentheses, is drawn hollow, and"
                + " counts in no slope. A reference follows as many bounces as the images do; what"
                + " those leave out is bounded by the truncation."));
    page.add(
        new Block.Paragraph(
            "Every figure is of "
                + Study.RUNS
                + " runs with different seeds: errors are root mean squares over them, seconds"
                + " their median, of tracing alone, after a warm-up; below a millisecond the"
                + " start of the workers counts for more than the rays. A single sample lies in the middle of its pixel. The slope is"
                + " that of the line of least squares through the logarithms of error and rays,"
                + " without the single sample, with its 95 % bootstrap interval over the runs:"
                + " random samples would have -1/2. An error below a millionth of a level is"
                + " rounding, written as 0 and not drawn."));
  }

  private void chart(Cost cost, String word, String caption) {
    PanelChart.of(report.entries(), cost)
        .ifPresent(svg -> page.add(new Block.Figure(files + "-" + word + ".svg", caption, svg)));
  }

  /** One row a scene: its error at every fourth power of two. */
  private Block.Grid errors() {
    int most = 1;
    for (Report.Entry entry : report.entries()) {
      most = Math.max(most, entry.uniform().points().size());
    }
    List<String> head = new ArrayList<>(List.of("scene", "truth", "off by", "formula"));
    for (int i = 0; i < most; i += 2) {
      head.add(i == 0 ? "1 sample" : String.valueOf(1 << i));
    }
    head.add("slope");
    List<List<String>> rows = new ArrayList<>();
    for (Report.Entry entry : report.entries()) {
      Curve curve = entry.uniform();
      List<String> row = new ArrayList<>();
      row.add(entry.name());
      row.add(curve.truth().origin());
      row.add(level(curve.truth().uncertainty()));
      row.add(entry.formula().isPresent() ? level(entry.formula().getAsDouble()) : "–");
      for (int i = 0; i < most; i += 2) {
        row.add(i < curve.points().size() ? error(curve.points().get(i)) : "–");
      }
      row.add(curve.trend(Cost.RAYS).map(ReportPage::slope).orElse("–"));
      rows.add(row);
    }
    return new Block.Grid(head, rows);
  }

  private Block.Grid costs() {
    List<String> head =
        List.of(
            "scene",
            "pixels",
            "camera rays",
            "reflected",
            "refracted",
            "shadow",
            "rays per second",
            "1 sample takes",
            "truncation");
    List<List<String>> rows = new ArrayList<>();
    for (Report.Entry entry : report.entries()) {
      Curve curve = entry.uniform();
      Measurement last = curve.points().get(curve.points().size() - 1);
      Rays rays = last.rays();
      double seconds = last.seconds().median();
      rows.add(
          List.of(
              entry.name(),
              entry.width() + "x" + entry.height(),
              share(rays.camera(), rays),
              share(rays.reflection(), rays),
              share(rays.refraction(), rays),
              share(rays.shadow(), rays),
              Numbers.prefixed(rays.total() / seconds, ""),
              Numbers.prefixed(seconds / last.samples(), "s"),
              level(curve.truncation())));
    }
    return new Block.Grid(head, rows);
  }

  private static Block.Grid figures(Curve curve) {
    List<String> head =
        List.of(
            "samples",
            "levels",
            "largest",
            "linear",
            "largest linear",
            "seconds",
            "least",
            "most",
            "rays");
    List<List<String>> rows = new ArrayList<>();
    for (Measurement point : curve.points()) {
      Errors error = point.error();
      Spread seconds = point.seconds();
      rows.add(
          List.of(
              String.valueOf(point.samples()),
              error(point),
              level(error.maxLevels()),
              scientific(error.linear()),
              scientific(error.maxLinear()),
              Numbers.prefixed(seconds.median(), "s"),
              Numbers.prefixed(seconds.min(), "s"),
              Numbers.prefixed(seconds.max(), "s"),
              Numbers.prefixed(point.rays().total(), "")));
    }
    return new Block.Grid(head, rows);
  }

  private static String summary(Report.Entry entry) {
    String end = entry.uniform().complete() ? "" : "; the time limit ended it";
    String title = entry.title().equals(entry.name()) ? "" : ", " + entry.title();
    return entry.name() + title + " (" + entry.file() + ")" + end;
  }

  private static String error(Measurement point) {
    String level = level(point.error().levels());
    return point.trusted() ? level : "(" + level + ")";
  }

  private static String level(double levels) {
    return levels <= Curve.NONE ? "0" : Numbers.digits(levels);
  }

  private static String slope(Curve.Trend trend) {
    return String.format(
        Locale.ROOT,
        "%.2f (%.2f to %.2f)",
        trend.law().slope(),
        trend.interval().low(),
        trend.interval().high());
  }

  private static String share(double kind, Rays rays) {
    return String.format(Locale.ROOT, "%.0f %%", 100 * kind / rays.total());
  }

  private static String scientific(double value) {
    return value == 0 ? "0" : String.format(Locale.ROOT, "%.2e", value);
  }
}
