package glint.desktop;

import glint.render.Goal;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import picocli.CommandLine.Option;

/** Which image the pixel of a replay belongs to, and which of its samples is shown. */
final class ReplayOptions extends SamplingOptions {

  private OptionalInt samples = OptionalInt.empty();
  private OptionalDouble maxError = OptionalDouble.empty();

  @Option(
      names = "--samples",
      paramLabel = "N",
      description = "Samples of the pixel; 1 is its centre (default: 16).")
  void samples(int n) {
    samples = OptionalInt.of(Words.inRange(command, "--samples", n, 1, RenderSettings.MAX_SAMPLES));
  }

  @Option(
      names = "--max-error",
      paramLabel = "E",
      description = "Instead: the pixel of the image that is rendered to this error.")
  void maxError(double levels) {
    maxError = OptionalDouble.of(Words.levels(command, levels));
  }

  /**
   * Returns how the image is rendered.
   *
   * @throws picocli.CommandLine.ParameterException if options contradict each other
   */
  RenderSettings settings(Scene scene) {
    if (maxError.isPresent() && samples.isPresent()) {
      throw Words.wrong(command, "--samples leaves nothing to --max-error: give one of them");
    }
    Goal goal =
        maxError.isPresent()
            ? new Goal.Error(maxError.getAsDouble())
            : new Goal.Samples(samples.orElse(RenderSettings.DEFAULT_SAMPLES));
    return settings(scene, goal, 1, RenderSettings.DEFAULT_TILE, Set.of());
  }
}
