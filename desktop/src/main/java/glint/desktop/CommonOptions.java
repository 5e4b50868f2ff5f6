package glint.desktop;

import glint.render.Aov;
import glint.render.Goal;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.nio.file.Path;
import java.util.Set;
import picocli.CommandLine.Option;

/** What every command that renders lets its user choose, checked before anything is read. */
abstract class CommonOptions extends SamplingOptions {

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Where files go (default: ${DEFAULT-VALUE}).")
  Path out = Path.of("out");

  @Option(names = "--quiet", description = "Print errors only.")
  boolean quiet;

  int threads = Runtime.getRuntime().availableProcessors();
  int tile = RenderSettings.DEFAULT_TILE;

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Worker threads (default: one per core).")
  void threads(int n) {
    threads = Words.inRange(command, "--threads", n, 1, RenderSettings.MAX_THREADS);
  }

  @Option(
      names = "--tile",
      paramLabel = "N",
      description = "Edge of a tile in pixels (default: 32).")
  void tile(int n) {
    tile = Words.inRange(command, "--tile", n, 1, RenderSettings.MAX_TILE);
  }

  /** Returns how to render a scene with so many samples of every pixel. */
  RenderSettings settings(Scene scene, Goal goal, Set<Aov> aovs) {
    return settings(scene, goal, threads, tile, aovs);
  }
}
