package glint.desktop;

import glint.render.Aov;
import glint.render.Goal;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.util.Arrays;
import java.util.OptionalInt;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The options that choose the rays of an image, checked before anything is read. */
abstract class SamplingOptions {

  @Spec(Spec.Target.MIXEE)
  CommandSpec command;

  private OptionalInt depth = OptionalInt.empty();
  private int[] size;

  @Option(
      names = "--seed",
      paramLabel = "K",
      description = "Another randomisation of the samples (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Option(
      names = "--size",
      paramLabel = "WxH",
      description = "Size of the images in pixels (default: the scene's).")
  void size(String text) {
    if (!text.matches("[0-9]{1,9}x[0-9]{1,9}")) {
      throw Words.wrong(
          command, "--size must be columns x rows, such as 640x480, but is '" + text + "'");
    }
    int[] sides = Arrays.stream(text.split("x")).mapToInt(Integer::parseInt).toArray();
    try {
      Scene.checkSize(sides[0], sides[1]);
    } catch (IllegalArgumentException e) {
      throw Words.wrong(command, "--size: " + e.getMessage());
    }
    size = sides;
  }

  @Option(
      names = "--depth",
      paramLabel = "N",
      description = "At most N successive bounces, 0 for none (default: the scene's, or 64).")
  void depth(int n) {
    depth = OptionalInt.of(Words.inRange(command, "--depth", n, 0, RenderSettings.MAX_DEPTH));
  }

  /** Returns how to render a scene. */
  final RenderSettings settings(Scene scene, Goal goal, int threads, int tile, Set<Aov> aovs) {
    int width = size == null ? scene.width() : size[0];
    int height = size == null ? scene.height() : size[1];
    return new RenderSettings(width, height, goal, seed, depth, threads, tile, aovs);
  }
}
