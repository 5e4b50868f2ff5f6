package glint.desktop;

import glint.render.Aov;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.OptionalInt;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** What every command that renders lets its user choose, checked before anything is read. */
abstract class CommonOptions {

  @Spec(Spec.Target.MIXEE)
  CommandSpec command;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Where files go (default: ${DEFAULT-VALUE}).")
  Path out = Path.of("out");

  @Option(names = "--quiet", description = "Print errors only.")
  boolean quiet;

  int threads = Runtime.getRuntime().availableProcessors();
  int tile = RenderSettings.DEFAULT_TILE;
  OptionalInt depth = OptionalInt.empty();
  private int[] size;

  @Option(
      names = "--seed",
      paramLabel = "K",
      description = "Another randomisation of the samples (default: ${DEFAULT-VALUE}).")
  long seed;

  @Option(
      names = "--size",
      paramLabel = "WxH",
      description = "Size of the images in pixels (default: the scene's).")
  void size(String text) {
    if (!text.matches("[0-9]{1,9}x[0-9]{1,9}")) {
      throw wrong("--size must be columns x rows, such as 640x480, but is '" + text + "'");
    }
    int[] sides = Arrays.stream(text.split("x")).mapToInt(Integer::parseInt).toArray();
    try {
      Scene.checkSize(sides[0], sides[1]);
    } catch (IllegalArgumentException e) {
      throw wrong("--size: " + e.getMessage());
    }
    size = sides;
  }

  @Option(
      names = "--depth",
      paramLabel = "N",
      description = "At most N successive bounces, 0 for none (default: the scene's, or 64).")
  void depth(int n) {
    depth = OptionalInt.of(inRange("--depth", n, 0, RenderSettings.MAX_DEPTH));
  }

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Worker threads (default: one per core).")
  void threads(int n) {
    threads = inRange("--threads", n, 1, RenderSettings.MAX_THREADS);
  }

  @Option(
      names = "--tile",
      paramLabel = "N",
      description = "Edge of a tile in pixels (default: 32).")
  void tile(int n) {
    tile = inRange("--tile", n, 1, RenderSettings.MAX_TILE);
  }

  /** Returns how to render a scene with so many samples of every pixel. */
  RenderSettings settings(Scene scene, int samples, Set<Aov> aovs) {
    int width = size == null ? scene.width() : size[0];
    int height = size == null ? scene.height() : size[1];
    return new RenderSettings(width, height, samples, seed, depth, threads, tile, aovs);
  }

  private ParameterException wrong(String message) {
    return new ParameterException(command.commandLine(), message);
  }

  /** Returns a number that lies within the renderer's own limits. */
  final int inRange(String option, int n, int least, int most) {
    if (n < least || n > most) {
      throw wrong(option + " must be " + least + " to " + most + ", but is " + n);
    }
    return n;
  }
}
