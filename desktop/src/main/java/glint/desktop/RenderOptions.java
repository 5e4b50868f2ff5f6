package glint.desktop;

import glint.render.Aov;
import glint.render.Goal;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Option;

/** The options of a render. */
final class RenderOptions extends CommonOptions {

  private static final Pattern TIME = Pattern.compile("([0-9]{1,9}(?:[.][0-9]{1,9})?)(s|m|h)");
  private static final Map<String, Integer> UNITS = Map.of("s", 1, "m", 60, "h", 3600);

  /** A kind of image file. */
  enum Format {
    PNG,
    PFM,
    BOTH
  }

  @Option(
      names = "--stats",
      paramLabel = "FILE",
      description = "Write the statistics of the run as JSON.")
  Path stats;

  @Option(names = "--resume", description = "Continue an interrupted batch: keep what is finished.")
  boolean resume;

  Format format = Format.PNG;
  private OptionalInt samples = OptionalInt.empty();
  private OptionalDouble maxError = OptionalDouble.empty();
  private OptionalDouble timeLimit = OptionalDouble.empty();
  final Set<Aov> aovs = EnumSet.noneOf(Aov.class);

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      description = "png, pfm (linear, 32-bit float) or both (default: png).")
  void format(String name) {
    format = Words.pick(command, "--format", name, Format.class);
  }

  @Option(
      names = "--samples",
      paramLabel = "N",
      description = "Exactly N samples of every pixel; 1 is its centre.")
  void samples(int n) {
    samples = OptionalInt.of(Words.inRange(command, "--samples", n, 1, RenderSettings.MAX_SAMPLES));
  }

  @Option(
      names = "--max-error",
      paramLabel = "E",
      description = "Stop at an estimated RMS error of E display levels (default: 1).")
  void maxError(double levels) {
    maxError = OptionalDouble.of(Words.levels(command, levels));
  }

  @Option(
      names = "--time-limit",
      paramLabel = "T",
      description = "Stop rendering a scene after T, such as 30s or 5m.")
  void timeLimit(String text) {
    Matcher parts = TIME.matcher(text);
    double seconds = parts.matches() ? Double.parseDouble(parts.group(1)) : 0;
    if (!(seconds > 0)) {
      throw Words.wrong(
          command, "--time-limit must be a time such as 30s, 5m or 1h, but is '" + text + "'");
    }
    timeLimit = OptionalDouble.of(seconds * UNITS.get(parts.group(2)));
  }

  @Option(
      names = "--aov",
      paramLabel = "LIST",
      description = "Extra PFM images: any of depth,normal,albedo,samples,error,id.")
  void aov(String list) {
    for (String name : list.split(",", -1)) {
      aovs.add(Words.pick(command, "--aov", name, Aov.class));
    }
  }

  /** Returns whether PNG images are asked for. */
  boolean png() {
    return format != Format.PFM;
  }

  /** Returns whether PFM images are asked for. */
  boolean pfm() {
    return format != Format.PNG;
  }

  /** Returns how to render a scene. */
  RenderSettings settings(Scene scene) {
    return settings(scene, goal(), aovs);
  }

  /**
   * Returns when an image is good enough.
   *
   * @throws picocli.CommandLine.ParameterException if options contradict each other
   */
  Goal goal() {
    if (samples.isEmpty()) {
      double levels = maxError.orElse(timeLimit.isPresent() ? 0 : 1);
      return new Goal.Error(levels, timeLimit.orElse(Double.POSITIVE_INFINITY));
    }
    if (maxError.isPresent() || timeLimit.isPresent()) {
      String other = maxError.isPresent() ? "--max-error" : "--time-limit";
      throw Words.wrong(command, "--samples leaves nothing to " + other + ": give one of them");
    }
    return new Goal.Samples(samples.getAsInt());
  }
}
