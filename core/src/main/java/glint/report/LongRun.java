package glint.report;

import glint.color.Rgb;
import glint.color.Transfer;
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
 * <p>Every pixel has {@link #LEAST} samples in each half, in small images more. Where the halves
 * differ, in the pixel and around, it has four times as many, and so on, as long as that is not the
 * work of hours. Halves may be equal by chance, and are beside an edge more often than not; so
 * neither may have moved, either, since it had a quarter of its samples. No estimate and no model
 * has a part in it.
 */
public final class LongRun {

  /** Samples of every pixel in each half at least. */
  static final int LEAST = 64;

  /** Samples of all pixels together in each half at least, as far as one may have so many. */
  private static final double ALL = 0x1p20;

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

  /** By pixel, how far the halves are apart or have moved last, in levels. */
  private final double[] doubt;

  private LongRun(Prepared scene, RenderSettings settings, BooleanSupplier cancelled) {
    this.scene = scene;
    this.cancelled = cancelled;
    doubt = new double[settings.width() * settings.height()];
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
    int samples = LEAST;
    while (samples < MOST && samples * (double) run.doubt.length < ALL) {
      samples *= GROWTH;
    }
    run.render(samples / GROWTH);
    Image[] before = run.images.clone();
    double rays = run.render(samples) / samples / run.doubt.length;
    run.compare(before);
    int[] apart = run.apart(IntStream.range(0, run.doubt.length).toArray());
    while (samples < MOST && apart.length > 0 && rays * apart.length * GROWTH * samples <= WORK) {
      samples *= GROWTH;
      run.sample(apart, samples);
      apart = run.apart(apart);
    }
    return Reference.of(run.images[0], run.images[1], ORIGIN, scene.scene().transfer());
  }

  /** Renders both halves; returns how many rays one of them took. */
  private double render(int samples) {
    double rays = 0;
    for (int half = 0; half < 2; half++) {
      if (cancelled.getAsBoolean()) {
        throw new CancellationException("rendering was cancelled");
      }
      RenderSettings all = halves[half].sampled(samples, halves[half].seed());
      RenderResult result = new Renderer(scene, all.following(NEGLIGIBLE)).render(Progress.NONE);
      images[half] = result.image();
      rays = result.statistics().rays().total();
    }
    return rays;
  }

  /** Finds how far the halves are apart, or from what they were. */
  private void compare(Image[] before) {
    Transfer transfer = scene.scene().transfer();
    double[] apart = Errors.ofPixels(images[0], images[1], transfer);
    double[] one = Errors.ofPixels(images[0], before[0], transfer);
    double[] two = Errors.ofPixels(images[1], before[1], transfer);
    Arrays.setAll(doubt, i -> Math.max(apart[i], Math.max(one[i], two[i])));
  }

  /** Returns those of some pixels where the halves do not agree. */
  private int[] apart(int[] pixels) {
    return Arrays.stream(pixels)
        .filter(pixel -> doubt[pixel] > SURELY * AGREEMENT && around(pixel) > AGREEMENT)
        .toArray();
  }

  /** Returns the greatest doubt in a pixel and those around it. */
  private double around(int pixel) {
    int width = images[0].width();
    int height = images[0].height();
    int column = pixel % width;
    int row = pixel / width;
    double most = 0;
    for (int y = Math.max(0, row - 1); y <= Math.min(height - 1, row + 1); y++) {
      for (int x = Math.max(0, column - 1); x <= Math.min(width - 1, column + 1); x++) {
        most = Math.max(most, doubt[y * width + x]);
      }
    }
    return most;
  }

  private void sample(int[] pixels, int samples) {
    Image[] before = images.clone();
    for (int half = 0; half < 2; half++) {
      RenderSettings more =
          halves[half].sampled(samples, halves[half].seed()).following(NEGLIGIBLE);
      Image image = copy(images[half]);
      images[half] = image;
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
    compare(before);
  }

  private static Image copy(Image image) {
    Image copy = new Image(image.width(), image.height());
    System.arraycopy(image.rgb(), 0, copy.rgb(), 0, copy.rgb().length);
    return copy;
  }
}
