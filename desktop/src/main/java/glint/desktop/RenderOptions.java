package glint.desktop;

import glint.render.Aov;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import picocli.CommandLine.Option;

/** The options of a render. */
final class RenderOptions extends CommonOptions {

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
  int samples = RenderSettings.DEFAULT_SAMPLES;
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
      description = "Samples of every pixel; 1 is its centre (default: 16).")
  void samples(int n) {
    samples = Words.inRange(command, "--samples", n, 1, RenderSettings.MAX_SAMPLES);
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
    return settings(scene, samples, aovs);
  }
}
