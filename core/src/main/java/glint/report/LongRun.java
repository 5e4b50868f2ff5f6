package glint.report;

import glint.color.Rgb;
import glint.image.Image;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.render.Replay;
import glint.scene.Prepared;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Finds what a scene looks like where no formula says so: twice, with samples that the two halves
 * do not share, until these agree.
 *
 * <p>Every pixel has {@link #LEAST} samples in each half. Where the halves differ, in the pixel and
 * around, it has four times as many, and so on, as long as that is not the work of hours. No
 * estimate and no model has a part in it.
 */
public final class LongRun {

  /** Samples of every pixel in each half. */
  static final int LEAST = 64;

  /** The most samples of a pixel in each half. */
  static final int MOST = 1 << 14;

  /** What its references say of themselves. */
  public static final String ORIGIN = "2 × " + LEAST + " to " + MOST + " samples";

  private static final int GROWTH = 4;

  /** The most rays that are traced at once in each half: minutes, not hours. */
  private static final double WORK = 3e7;

  /** Differences of halves, in display levels, that are small enough. */
  private static final double AGREEMENT = 0.25;

  /** Halves that are so much closer than that agree whatever the neighbours do. */
  private static final double SURELY = 1 / 32.0;

  /** What is not followed: far below what any image shows. */
  private static final double NEGLIGIBLE = 0x1p-20;

  private final Prepared scene;
  private final RenderSettings[] halves;
  private final BooleanSupplier cancelled;
  private final Image[] images = new Image[2];

  private LongRun(Prepared scene, RenderSettings settings, BooleanSupplier cancelled) {
    this.scene = scene;
    this.cancelled = cancelled;
    // Seeds before those of the runs, so that no sample is shared with what is measured.
    halves =
        new RenderSettings[] {
          settings.sampled(LEAST, settings.seed() - 1), settings.sampled(LEAST, settings.seed() - 2)
        };
  }

  /**
   * Renders both halves, on all cores.
   *
   * @param settings their goal is set aside
   * @throws CancellationException if it was cancelled
   */
  public static Reference of(Prepared scene, RenderSettings settings, BooleanSupplier cancelled) {
    LongRun run = new LongRun(scene, settings, cancelled);
    double rays = 0;
    for (int half = 0; half < 2; half++) {
      RenderSettings all = run.halves[half].following(NEGLIGIBLE);
      RenderResult result = new Renderer(scene, all).render(Progress.NONE);
      run.images[half] = result.image();
      rays = result.statistics().rays().total();
    }
    int[] apart = run.apart(IntStream.range(0, settings.width() * settings.height()).toArray());
    rays /= LEAST * (double) (settings.width() * settings.height());
    int samples = GROWTH * LEAST;
    while (samples <= MOST && apart.length > 0 && rays * apart.length * samples <= WORK) {
      run.sample(apart, samples);
      apart = run.apart(apart);
      samples *= GROWTH;
    }
    return Reference.of(run.images[0], run.images[1], ORIGIN, scene.scene().transfer());
  }

  /** Returns those of some pixels where the halves do not agree. */
  private int[] apart(int[] pixels) {
    int width = images[0].width();
    int height = images[0].height();
    double[] delta = Errors.ofPixels(images[0], images[1], scene.scene().transfer());
    return Arrays.stream(pixels)
        .filter(
            pixel -> {
              double around = 0;
              for (int y = Math.max(0, pixel / width - 1);
                  y <= Math.min(height - 1, pixel / width + 1);
                  y++) {
                for (int x = Math.max(0, pixel % width - 1);
                    x <= Math.min(width - 1, pixel % width + 1);
                    x++) {
                  around = Math.max(around, delta[y * width + x]);
                }
              }
              return delta[pixel] > SURELY * AGREEMENT && around > AGREEMENT;
            })
        .toArray();
  }

  private void sample(int[] pixels, int samples) {
    for (int half = 0; half < 2; half++) {
      RenderSettings more =
          halves[half].sampled(samples, halves[half].seed()).following(NEGLIGIBLE);
      Image image = images[half];
      Arrays.stream(pixels)
          .parallel()
          .forEach(
              pixel -> {
                if (cancelled.getAsBoolean()) {
                  throw new CancellationException("rendering was cancelled");
                }
                int x = pixel % image.width();
                int y = pixel / image.width();
                Rgb value = new Replay(scene, more, x, y).value();
                image.set(x, y, value.r(), value.g(), value.b());
              });
    }
  }
}
