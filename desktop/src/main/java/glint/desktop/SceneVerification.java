package glint.desktop;

import glint.color.Rgb;
import glint.render.RenderSettings;
import glint.scene.Expectation;
import glint.scene.Scene;
import glint.verify.Outcome;
import glint.verify.Verdict;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;

/** Checks what the scenes of some files say of their own pictures. */
final class SceneVerification {

  private final PrintWriter out;
  private final PrintWriter err;
  private final boolean json;
  private boolean failed;

  SceneVerification(PrintWriter out, PrintWriter err, boolean json) {
    this.out = out;
    this.err = err;
    this.json = json;
  }

  /** Reads all files, renders the scenes that expect something, and returns the exit code. */
  int run(List<Path> files) {
    Inputs inputs = Inputs.read(files, err);
    inputs.problems().forEach(problem -> fail(problem.message()));
    for (Path file : files) {
      List<Scene> scenes = scenes(inputs, file);
      if (!scenes.isEmpty() && scenes.stream().allMatch(s -> s.expectations().isEmpty())) {
        fail(file + ": no scene says by 'expect' what its picture must show: nothing to verify");
      }
    }
    int width = inputs.jobs().stream().mapToInt(SceneVerification::idWidth).max().orElse(4);
    CaseTable table = new CaseTable(out, json, width);
    for (Job job : inputs.jobs()) {
      verify(job, table);
    }
    return table.end() == 0 && !failed ? ExitCode.DONE : ExitCode.FAILED;
  }

  private static List<Scene> scenes(Inputs inputs, Path file) {
    return inputs.jobs().stream().filter(job -> job.file().equals(file)).map(Job::scene).toList();
  }

  private void verify(Job job, CaseTable table) {
    Scene scene = job.scene();
    if (scene.expectations().isEmpty()) {
      return;
    }
    try {
      Memory.check(scene.width(), scene.height(), 0);
      List<Verdict> verdicts = Verdict.of(scene, Runtime.getRuntime().availableProcessors());
      for (int i = 0; i < verdicts.size(); i++) {
        Verdict verdict = verdicts.get(i);
        Outcome row = verdict.outcome(id(scene, i), what(verdict));
        table.add(row, command(job, verdict.expectation()));
      }
    } catch (RunException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
      fail(scene.name() + ": " + Reasons.of(e));
      Reasons.trace(e, err);
    }
  }

  private void fail(String message) {
    failed = true;
    err.println(message);
  }

  /** Numbers the expectations of a scene from 1, if it has several. */
  private static String id(Scene scene, int index) {
    return scene.expectations().size() == 1 ? scene.name() : scene.name() + "#" + (index + 1);
  }

  private static int idWidth(Job job) {
    return id(job.scene(), job.scene().expectations().size() - 1).length();
  }

  private static String what(Verdict verdict) {
    Expectation e = verdict.expectation();
    String place = e.pixel().map(p -> "pixel " + p.x() + "," + p.y()).orElse("mean");
    if (verdict.passed()) {
      return place + " is " + words(e.value());
    }
    return place
        + " must be "
        + words(e.value())
        + ", but is "
        + words(verdict.actual())
        + (verdict.invalid() == 0 ? "" : "; " + verdict.invalid() + " samples are no numbers");
  }

  private static String words(Rgb color) {
    boolean grey = color.r() == color.g() && color.g() == color.b();
    return grey ? "" + color.r() : "[" + color.r() + ", " + color.g() + ", " + color.b() + "]";
  }

  /**
   * Returns the command that shows where a value comes from. It states the depth, as rays are then
   * followed as far as a fine tolerance asks.
   */
  private static String command(Job job, Expectation e) {
    Scene scene = job.scene();
    int depth = scene.maxDepth().orElse(RenderSettings.DEFAULT_DEPTH);
    RenderSettings settings =
        new RenderSettings(
            scene.width(),
            scene.height(),
            e.samples(),
            0,
            OptionalInt.of(e.maxDepth().orElse(depth)),
            1,
            RenderSettings.DEFAULT_TILE,
            Set.of());
    return e.pixel()
        .map(p -> SeeAgain.pixel(job.file(), scene, settings, p.x(), p.y()))
        .orElseGet(() -> SeeAgain.image(job.file(), scene, settings));
  }
}
