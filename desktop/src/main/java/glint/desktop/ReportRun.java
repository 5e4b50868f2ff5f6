package glint.desktop;

import glint.desktop.report.Report;
import glint.desktop.report.ReportFiles;
import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.report.Answers;
import glint.report.Curve;
import glint.report.DepthStudy;
import glint.report.LongRun;
import glint.report.Measurement;
import glint.report.Reference;
import glint.report.Study;
import glint.report.TargetStudy;
import glint.report.ThinLines;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CancellationException;

/** Measures the scenes of some files and writes the report on them. */
final class ReportRun {

  /** A reference, its halves, and the image that is compared with it. */
  private static final int EXTRA_IMAGES = 3;

  /** The widths of lines that are looked for, in pixels. */
  private static final List<Double> LINES = List.of(0.05, 0.2, 0.5);

  private final SceneFilter filter;
  private final ReportOptions options;
  private final Reporter reporter;
  private final Interrupt interrupt;
  private final List<Report.Entry> entries = new ArrayList<>();
  private boolean failed;

  /** Sets up a report. */
  ReportRun(SceneFilter filter, ReportOptions options, Reporter reporter, Interrupt interrupt) {
    this.filter = filter;
    this.options = options;
    this.reporter = reporter;
    this.interrupt = interrupt;
  }

  /**
   * Reads all files, measures their scenes one after another, and returns the exit code.
   *
   * @param command the whole command, for the report to name
   * @throws RunException if there is nothing to report or it cannot be written
   */
  int run(String command, List<Path> paths) throws RunException {
    Inputs inputs = Inputs.read(paths, reporter.err());
    inputs.notes().forEach(reporter::note);
    inputs.problems().forEach(this::fail);
    List<Job> jobs = filter.select(inputs, this::fail);
    UniqueNames.check(jobs, job -> List.of(job.scene().name()));
    if (!jobs.isEmpty()) {
      Folders.make(options.out);
    }
    try {
      jobs.forEach(this::measure);
    } catch (CancellationException e) {
      reporter.error("interrupted: no report is written");
      return ExitCode.INTERRUPTED;
    }
    if (!entries.isEmpty()) {
      List<ThinLines.Count> lines = LINES.stream().map(ThinLines::count).toList();
      Report report = new Report(command, Machine.environment(options.threads), entries, lines);
      write(ReportFiles.of(report));
    }
    return failed ? ExitCode.FAILED : ExitCode.DONE;
  }

  private void measure(Job job) {
    Scene scene = job.scene();
    try {
      RenderSettings asked = options.settings(scene, new Goal.Samples(1), Set.of());
      RenderSettings settings = Answers.settings(scene, asked);
      Memory.check(settings.width(), settings.height(), EXTRA_IMAGES);
      Prepared prepared = Prepared.of(scene);
      Study.Render render =
          each -> {
            Renderer renderer = new Renderer(prepared, each);
            interrupt.watch(renderer);
            return renderer.render(Progress.NONE);
          };
      entries.add(entry(job, prepared, settings, render));
      Curve curve = entries.get(entries.size() - 1).uniform();
      reporter.note(scene.name() + ": " + outcome(curve));
    } catch (CancellationException e) {
      throw e;
    } catch (RunException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
      fail(new Failed(scene.name(), scene.name() + ": " + Reasons.of(e)));
      Reasons.trace(e, reporter.err());
    }
  }

  private Report.Entry entry(
      Job job, Prepared prepared, RenderSettings settings, Study.Render render) {
    Scene scene = job.scene();
    int width = settings.width();
    int height = settings.height();
    Optional<Answers> answers = Answers.of(scene);
    Reference truth =
        answers
            .flatMap(a -> a.image(width, height).map(image -> a.reference(image)))
            .orElseGet(() -> LongRun.of(prepared, settings, interrupt::requested));
    Curve curve = new Study(render, settings, options.samples, options.timeLimit).run(truth);
    TargetStudy targets = TargetStudy.of(render, settings, truth);
    DepthStudy depths = DepthStudy.of(render, settings, truth);
    RenderSettings looked = settings.aiming(TargetStudy.LOOKED_AT, settings.seed(), Set.of());
    List<String> replays =
        targets.worst().stream()
            .map(each -> SeeAgain.pixel(job.file(), scene, looked, each.x(), each.y()))
            .toList();
    OptionalDouble formula =
        answers.isPresent()
            ? OptionalDouble.of(answers.get().errors(truth.image()).levels())
            : OptionalDouble.empty();
    return new Report.Entry(
        job.file().toString(),
        scene.name(),
        scene.title(),
        width,
        height,
        curve,
        targets,
        depths,
        replays,
        formula);
  }

  private static String outcome(Curve curve) {
    Measurement last = curve.points().get(curve.points().size() - 1);
    double levels = last.error().levels();
    return String.format(
        Locale.ROOT,
        "%s with %s, against %s%s%s",
        levels > Curve.NONE ? String.format(Locale.ROOT, "error %.3g levels", levels) : "no error",
        Figures.count(last.samples(), "sample"),
        curve.truth().origin(),
        last.trusted() ? "" : ", too coarse to tell",
        curve.complete() ? "" : "; the time limit ended it");
  }

  private void write(Map<String, String> files) throws RunException {
    for (Map.Entry<String, String> file : files.entrySet()) {
      Path target = options.out.resolve(file.getKey());
      try {
        AtomicFile.write(target, path -> Files.writeString(path, file.getValue()));
      } catch (IOException e) {
        throw new RunException("cannot write " + Reasons.of(target, e), e);
      }
      reporter.note("-> " + target);
    }
  }

  private void fail(Failed failure) {
    failed = true;
    reporter.error(failure.message());
  }
}
