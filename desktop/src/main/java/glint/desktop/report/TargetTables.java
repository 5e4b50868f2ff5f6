package glint.desktop.report;

import glint.report.Calibration;
import glint.report.Curve;
import glint.report.Honesty;
import glint.report.Measurement.Cost;
import glint.report.Pace;
import glint.report.TargetRuns;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Tables of what renders to an error cost and claim. */
final class TargetTables {

  /** What a pixel may be off without anybody being told. */
  static final double SILENT = 4;

  /** The target of which there is a row for each scene. */
  private static final double MAIN = 1;

  /** Images of fewer pixels do not count for means: starting takes longer than tracing them. */
  private static final int PICTURE = 1024;

  private TargetTables() {}

  /** What a render to one level costs beside uniform sampling with the same true error. */
  static Block.Grid equalError(Report report) {
    List<List<String>> rows = new ArrayList<>();
    Map<String, List<double[]>> files = new LinkedHashMap<>();
    for (Report.Entry entry : report.entries()) {
      for (TargetRuns runs : entry.targets().runs()) {
        if (runs.target() == MAIN) {
          List<String> row = new ArrayList<>(List.of(entry.name()));
          equalError(row, entry.uniform(), runs);
          rows.add(row);
          Optional<Pace> seconds = Pace.of(entry.uniform(), runs, Cost.SECONDS);
          Optional<Pace> rays = Pace.of(entry.uniform(), runs, Cost.RAYS);
          if (seconds.isPresent() && entry.width() * entry.height() >= PICTURE) {
            double[] times = {seconds.get().times(), rays.get().times()};
            files.computeIfAbsent(entry.file(), file -> new ArrayList<>()).add(times);
          }
        }
      }
    }
    files.forEach(
        (file, times) ->
            rows.add(
                List.of(
                    "mean of " + file,
                    "",
                    "",
                    "",
                    "",
                    "",
                    ratio(mean(times, 0)),
                    ratio(mean(times, 1)))));
    List<String> head =
        List.of(
            "scene", "true error", "claimed", "seconds", "rays", "uniform", "faster", "fewer rays");
    return new Block.Grid(head, rows);
  }

  /** The same for all targets of a scene. */
  static Block.Grid equalError(Report.Entry entry) {
    List<List<String>> rows = new ArrayList<>();
    for (TargetRuns runs : entry.targets().runs()) {
      List<String> row = new ArrayList<>(List.of(target(runs)));
      equalError(row, entry.uniform(), runs);
      rows.add(row);
    }
    List<String> head =
        List.of(
            "target",
            "true error",
            "claimed",
            "seconds",
            "rays",
            "uniform",
            "faster",
            "fewer rays");
    return new Block.Grid(head, rows);
  }

  private static void equalError(List<String> row, Curve uniform, TargetRuns runs) {
    row.add(level(runs.error().levels()));
    row.add(level(claimed(runs)));
    row.add(Numbers.prefixed(runs.seconds().median(), "s"));
    row.add(Numbers.prefixed(runs.rays().total(), ""));
    Optional<Pace> seconds = Pace.of(uniform, runs, Cost.SECONDS);
    Optional<Pace> rays = Pace.of(uniform, runs, Cost.RAYS);
    row.add(seconds.map(TargetTables::samples).orElse("–"));
    row.add(seconds.map(TargetTables::times).orElse("–"));
    row.add(rays.map(TargetTables::times).orElse("–"));
  }

  /** What error either way of sampling has at the time that renders to an error take. */
  static Block.Grid equalTime(Report report) {
    List<String> head = new ArrayList<>(List.of("scene"));
    for (TargetRuns runs : report.entries().get(0).targets().runs()) {
      head.addAll(List.of("target " + target(runs), "uniform"));
    }
    List<List<String>> rows = new ArrayList<>();
    for (Report.Entry entry : report.entries()) {
      List<String> row = new ArrayList<>(List.of(entry.name()));
      for (TargetRuns runs : entry.targets().runs()) {
        String time = Numbers.prefixed(runs.seconds().median(), "s");
        row.add(level(runs.error().levels()) + " in " + time);
        row.add(
            Pace.of(entry.uniform(), runs, Cost.SECONDS)
                .map(pace -> level(pace.errorAtCost()))
                .orElse("–"));
      }
      rows.add(row);
    }
    return new Block.Grid(head, rows);
  }

  /** Whether images keep their targets. */
  static Block.Grid honesty(Report report) {
    Map<String, List<Honesty.Claim>> claims = new LinkedHashMap<>();
    for (Report.Entry entry : report.entries()) {
      for (TargetRuns runs : entry.targets().runs()) {
        claims.computeIfAbsent(target(runs), t -> new ArrayList<>()).addAll(runs.claims());
      }
    }
    List<Honesty.Claim> all = new ArrayList<>();
    claims.values().forEach(all::addAll);
    claims.put("all", all);
    List<List<String>> rows = new ArrayList<>();
    claims.forEach(
        (target, each) -> {
          Honesty honesty = Honesty.of(each);
          rows.add(
              List.of(
                  target,
                  String.valueOf(honesty.runs()),
                  percent(honesty.kept()),
                  ratio(honesty.ratio().median()),
                  ratio(honesty.ratio().min()),
                  ratio(honesty.ratio().max())));
        });
    List<String> head = List.of("target", "images", "kept", "true over claimed", "least", "most");
    return new Block.Grid(head, rows);
  }

  /** Whether pixels keep their claims, and the images that they are of. */
  static Block.Grid calibration(Report report) {
    List<List<String>> rows = new ArrayList<>();
    for (Report.Entry entry : report.entries()) {
      List<Honesty.Claim> claims = new ArrayList<>();
      entry.targets().runs().forEach(runs -> claims.addAll(runs.claims()));
      Honesty honesty = Honesty.of(claims);
      Calibration c = Calibration.of(entry.targets().claimed(), entry.targets().actual(), SILENT);
      List<String> row = new ArrayList<>(List.of(entry.name(), percent(honesty.kept())));
      row.add(ratio(honesty.ratio().median()));
      row.add(ratio(c.ratio()));
      c.coverage().forEach(share -> row.add(percent(share)));
      row.add(ratio(c.spearman()));
      row.add(String.valueOf(c.silentMisses()));
      rows.add(row);
    }
    List<String> head =
        List.of(
            "scene",
            "kept",
            "true over claimed",
            "pixels: claimed over true",
            "within 1 σ",
            "2 σ",
            "3 σ",
            "ranks",
            "silent");
    return new Block.Grid(head, rows);
  }

  private static String target(TargetRuns runs) {
    return Numbers.digits(runs.target());
  }

  private static double claimed(TargetRuns runs) {
    return runs.claims().stream().mapToDouble(Honesty.Claim::claimed).average().orElse(0);
  }

  private static double mean(List<double[]> values, int which) {
    double sum = 0;
    for (double[] value : values) {
      sum += Math.log(value[which]);
    }
    return Math.exp(sum / values.size());
  }

  private static String samples(Pace pace) {
    String samples = Numbers.digits(Math.ceil(pace.samples()));
    return pace.measured() ? samples : "about " + samples;
  }

  private static String times(Pace pace) {
    String low = ratio(pace.interval().low());
    return ratio(pace.times()) + " (" + low + "–" + ratio(pace.interval().high()) + ")";
  }

  private static String ratio(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%.2f", value) : "–";
  }

  private static String percent(double share) {
    return Double.isFinite(share) ? String.format(Locale.ROOT, "%.1f %%", 100 * share) : "–";
  }

  private static String level(double levels) {
    return levels <= Curve.NONE ? "0" : Numbers.digits(levels);
  }
}
