package glint.desktop;

import glint.scene.World;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;

/** Renders the scenes of some files, one after another; one that fails does not stop the others. */
final class Batch {

  private final SceneFilter filter;
  private final RenderOptions options;
  private final Reporter reporter;
  private final Interrupt interrupt;
  private final List<SceneStats> finished = new ArrayList<>();
  private final List<Failed> failed = new ArrayList<>();
  private boolean interrupted;

  /** Sets up a batch. */
  Batch(SceneFilter filter, RenderOptions options, Reporter reporter, Interrupt interrupt) {
    this.filter = filter;
    this.options = options;
    this.reporter = reporter;
    this.interrupt = interrupt;
  }

  /**
   * Reads all files, renders their scenes, and returns the exit code.
   *
   * @throws RunException if nothing can be rendered at all
   */
  int run(List<Path> paths) throws RunException {
    Inputs inputs = Inputs.read(paths, reporter.err());
    inputs.notes().forEach(reporter::note);
    inputs.problems().forEach(this::fail);
    List<Job> jobs = filter.select(inputs, this::fail);
    List<Job> pictures = jobs.stream().flatMap(job -> job.pictures().stream()).toList();
    UniqueNames.check(pictures, job -> OutputFiles.names(job.scene().name(), options));
    if (options.stats != null) {
      StatsFile.check(options.stats);
    }
    if (!jobs.isEmpty()) {
      Folders.make(options.out);
    }
    for (Job job : jobs) {
      World world = new World(job.scene());
      job.pictures().forEach(picture -> run(picture, world));
    }
    return end(pictures.size() + inputs.broken());
  }

  private void run(Job job, World world) {
    interrupted = interrupted || interrupt.requested();
    if (interrupted) {
      return;
    }
    String name = job.scene().name();
    try {
      finished.add(new SceneRun(job, world, options).run(reporter, interrupt));
    } catch (CancellationException e) {
      interrupted = true;
    } catch (RunException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
      fail(new Failed(name, name + ": " + Reasons.of(e)));
      Reasons.trace(e, reporter.err());
    } finally {
      reporter.close();
    }
  }

  private void fail(Failed failure) {
    failed.add(failure);
    reporter.error(failure.message());
  }

  private int end(int total) throws RunException {
    if (options.stats != null) {
      String java = Version.java();
      new StatsFile(Version.glint(), java, options.threads, finished, failed, interrupted)
          .write(options.stats);
    }
    String done = finished.size() + " of " + total + " scenes are finished";
    if (interrupted) {
      reporter.error("interrupted: " + done + "; --resume continues");
      return ExitCode.INTERRUPTED;
    }
    if (!failed.isEmpty()) {
      TreeSet<String> names = new TreeSet<>();
      failed.forEach(f -> names.add(f.name()));
      reporter.error(done + "; failed: " + String.join(", ", names));
      return ExitCode.FAILED;
    }
    return ExitCode.DONE;
  }
}
