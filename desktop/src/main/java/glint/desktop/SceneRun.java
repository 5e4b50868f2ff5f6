package glint.desktop;

import glint.image.Image;
import glint.io.Pfm;
import glint.render.Aov;
import glint.render.Goal;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.scene.World;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** Renders one scene and writes its files. */
final class SceneRun {

  private final Job job;
  private final RenderOptions options;
  private final RenderSettings settings;
  private final OutputFiles files;
  private final World world;

  /** Sets up the run of a scene, which is a picture of a world. */
  SceneRun(Job job, World world, RenderOptions options) {
    this.job = job;
    this.world = world;
    this.options = options;
    settings = options.settings(job.scene());
    files = OutputFiles.of(job.scene().name(), options);
  }

  /**
   * Renders and writes the scene, or keeps what an earlier run has written.
   *
   * @throws RunException if the image cannot be held or a file cannot be written
   * @throws java.util.concurrent.CancellationException if the run was interrupted meanwhile
   */
  SceneStats run(Reporter reporter, Interrupt interrupt) throws RunException {
    Optional<SceneStats> kept = Optional.empty();
    if (options.resume) {
      kept = Kept.find(job, settings, files, options.format);
    }
    if (kept.isPresent()) {
      reporter.kept(kept.get(), files);
      return kept.get();
    }
    if (settings.goal() instanceof Goal.Error) {
      Memory.checkRefined(settings.width(), settings.height(), settings.aovs().size());
    } else {
      Memory.check(settings.width(), settings.height(), settings.aovs().size());
    }

    long began = System.nanoTime();
    Prepared prepared = world.seenIn(job.scene());
    double build = secondsSince(began);

    Renderer renderer = new Renderer(prepared, settings);
    interrupt.watch(renderer);
    RenderResult result = renderer.render(reporter.begin(job.scene().name()));

    began = System.nanoTime();
    SceneStats stats = stats(result, build, 0);
    write(result, stats);
    stats = stats(result, build, secondsSince(began));
    reporter.finished(stats, files);
    if (result.statistics().invalid() > 0) {
      int pixel = result.statistics().invalidPixel();
      int column = pixel % settings.width();
      int row = pixel / settings.width();
      Scene scene = job.scene();
      reporter.note("see one: " + SeeAgain.pixel(job.file(), scene, settings, column, row));
    }
    return stats;
  }

  private SceneStats stats(RenderResult result, double build, double write) {
    double render = result.statistics().renderSeconds();
    SceneStats.Seconds seconds = new SceneStats.Seconds(job.loadSeconds(), build, render, write);
    return SceneStats.of(
        job.scene().name(), settings, seconds, result.statistics(), result.image());
  }

  /** Writes the PNG last: its record vouches for the others. */
  private void write(RenderResult result, SceneStats stats) throws RunException {
    Map<String, String> digests = new TreeMap<>();
    for (Map.Entry<Aov, Path> aov : files.aovs().entrySet()) {
      writePfm(result.aovs().get(aov.getKey()), aov.getValue(), digests);
    }
    if (files.pfm().isPresent()) {
      writePfm(result.image(), files.pfm().get(), digests);
    }
    if (files.png().isPresent()) {
      String fingerprint = RunRecord.fingerprint(job, settings, options.format);
      String record = new RunRecord(fingerprint, digests, stats).toJson();
      write(
          files.png().get(),
          path -> PngFile.write(result.image(), job.scene().transfer(), record, path));
    }
  }

  private static void writePfm(Image image, Path target, Map<String, String> digests)
      throws RunException {
    MessageDigest digest = Digests.begin();
    write(
        target,
        path -> {
          try (OutputStream out =
              new BufferedOutputStream(
                  new DigestOutputStream(Files.newOutputStream(path), digest), 1 << 16)) {
            Pfm.write(image, out);
          }
        });
    digests.put(target.getFileName().toString(), Digests.end(digest));
  }

  private static void write(Path target, AtomicFile.Content content) throws RunException {
    try {
      AtomicFile.write(target, content);
    } catch (IOException e) {
      throw new RunException("cannot write " + Reasons.of(target, e), e);
    }
  }

  private static double secondsSince(long nanoTime) {
    return (System.nanoTime() - nanoTime) * 1e-9;
  }
}
