package glint.desktop.window;

import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.report.Curve;
import glint.report.LongRun;
import glint.report.Reference;
import glint.report.Study;
import glint.report.TargetStudy;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;

/** Measures speed against error of one scene in the background, as {@code glint report} does. */
final class SpeedRun {

  /** The box that the measured image fits into: small, as the truth takes thousands of samples. */
  private static final int WIDTH = 120;

  private static final int HEIGHT = 90;

  private static final int MOST_SAMPLES = 1024;
  private static final double SECONDS = 8;

  private final Prepared prepared;
  private final RenderSettings settings;
  private final Consumer<String> progress;
  private final Consumer<Optional<Result>> done;
  private final Thread thread = new Thread(this::run, "glint-window-speed");
  private volatile boolean cancelled;
  private int images;

  /**
   * What was found; immutable.
   *
   * @param uniform of the same number of samples for every pixel
   * @param targets of renders to an error
   * @param width columns of the image that was measured
   * @param height its rows
   */
  record Result(Curve uniform, TargetStudy targets, int width, int height) {}

  /**
   * Sets up a run.
   *
   * @param progress hears in words, on any thread, how far it is
   * @param done hears, on another thread, what was found; nothing if the run was cancelled
   */
  SpeedRun(Prepared prepared, Consumer<String> progress, Consumer<Optional<Result>> done) {
    this.prepared = prepared;
    this.progress = progress;
    this.done = done;
    Scene scene = prepared.scene();
    double scale = Math.min(WIDTH / (double) scene.width(), HEIGHT / (double) scene.height());
    scale = Math.min(1, scale);
    settings =
        new RenderSettings(
            Math.max(1, (int) Math.rint(scale * scene.width())),
            Math.max(1, (int) Math.rint(scale * scene.height())),
            new Goal.Samples(1),
            0,
            OptionalInt.empty(),
            Runtime.getRuntime().availableProcessors(),
            RenderSettings.DEFAULT_TILE,
            Set.of());
    thread.setDaemon(true);
  }

  /** Begins. */
  void start() {
    thread.start();
  }

  /** Ends the run soon. */
  void cancel() {
    cancelled = true;
    thread.interrupt();
  }

  private void run() {
    Optional<Result> result = Optional.empty();
    try {
      progress.accept("looking for the truth");
      Reference truth = LongRun.of(prepared, settings, () -> cancelled);
      Curve curve = new Study(this::render, settings, MOST_SAMPLES, SECONDS).run(truth);
      TargetStudy targets = TargetStudy.of(this::render, settings, truth);
      result = Optional.of(new Result(curve, targets, settings.width(), settings.height()));
    } catch (CancellationException e) {
      result = Optional.empty();
    } finally {
      done.accept(result);
    }
  }

  private RenderResult render(RenderSettings each) {
    if (cancelled) {
      throw new CancellationException("measuring was cancelled");
    }
    images++;
    String what =
        each.goal() instanceof Goal.Samples exactly
            ? exactly.count() + (exactly.count() == 1 ? " sample" : " samples")
            : String.format(Locale.ROOT, "%.2g levels", ((Goal.Error) each.goal()).levels());
    progress.accept("image " + images + ", to " + what);
    return new Renderer(prepared, each).render(Progress.NONE);
  }
}
