package glint.desktop;

import glint.render.Goal;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.util.Set;
import picocli.CommandLine.Option;

/** Which image the pixel of a replay belongs to, and which of its samples is shown. */
final class ReplayOptions extends SamplingOptions {

  private int samples = RenderSettings.DEFAULT_SAMPLES;

  @Option(
      names = "--samples",
      paramLabel = "N",
      description = "Samples of the pixel; 1 is its centre (default: 16).")
  void samples(int n) {
    samples = Words.inRange(command, "--samples", n, 1, RenderSettings.MAX_SAMPLES);
  }

  /** Returns how the image is rendered. */
  RenderSettings settings(Scene scene) {
    return settings(scene, new Goal.Samples(samples), 1, RenderSettings.DEFAULT_TILE, Set.of());
  }
}
