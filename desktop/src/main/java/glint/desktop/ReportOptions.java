package glint.desktop;

import glint.render.RenderSettings;
import picocli.CommandLine.Option;

/** The options of a report. */
final class ReportOptions extends CommonOptions {

  int samples = 1024;
  double timeLimit = 60;

  @Option(
      names = "--samples",
      paramLabel = "N",
      description = "Measure 1, 2, 4, … up to N samples of every pixel (default: 1024).")
  void samples(int n) {
    samples = Words.inRange(command, "--samples", n, 1, RenderSettings.MAX_SAMPLES);
  }

  @Option(
      names = "--time-limit",
      paramLabel = "T",
      description =
          "Double the samples of a scene no more after T, such as 30s or 5m (default: 60s).")
  void timeLimit(String text) {
    timeLimit = Words.seconds(command, "--time-limit", text);
  }
}
