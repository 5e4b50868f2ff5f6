package glint.desktop;

import glint.render.Aov;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.OptionalInt;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The options of a render, checked as they are read. */
final class RenderOptions {

  /** A kind of image file. */
  enum Format {
    PNG,
    PFM,
    BOTH
  }

  // The renderer's own limits, to be told about before anything is read.

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Where images go (default: ${DEFAULT-VALUE}).")
  Path out = Path.of("out");

  @Option(
      names = "--stats",
      paramLabel = "FILE",
      description = "Write the statistics of the run as JSON.")
  Path stats;

  @Option(names = "--quiet", description = "Print errors only.")
  boolean quiet;

  @Option(names = "--resume", description = "Continue an interrupted batch: keep what is finished.")
  boolean resume;

  Format format = Format.PNG;
  int samples = RenderSettings.DEFAULT_SAMPLES;
  int threads = Runtime.getRuntime().availableProcessors();
  int tile = RenderSettings.DEFAULT_TILE;
  OptionalInt depth = OptionalInt.empty();
  final Set<Aov> aovs = EnumSet.noneOf(Aov.class);
  private int[] size;

  @Option(
      names = "--seed",
      paramLabel = "K",
      description = "Another randomisation of the samples (default: ${DEFAULT-VALUE}).")
  long seed;

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      description = "png, pfm (linear, 32-bit float) or both (default: png).")
  void format(String name) {
    format = Words.pick(command, "--format", name, Format.class);
  }

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
      names = "--samples",
      paramLabel = "N",
      description = "Samples of every pixel; 1 is its centre (default: 16).")
  void samples(int n) {
    samples = inRange("--samples", n, 1, RenderSettings.MAX_SAMPLES);
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

  @Option(
      names = "--aov",
      paramLabel = "LIST",
      description = "Extra PFM images: any of depth,normal,albedo,id.")
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
    int width = size == null ? scene.width() : size[0];
    int height = size == null ? scene.height() : size[1];
    return new RenderSettings(width, height, samples, seed, depth, threads, tile, aovs);
  }

  private ParameterException wrong(String message) {
    return new ParameterException(command.commandLine(), message);
  }

  private int inRange(String option, int n, int least, int most) {
    if (n < least || n > most) {
      throw wrong(option + " must be " + least + " to " + most + ", but is " + n);
    }
    return n;
  }
}
