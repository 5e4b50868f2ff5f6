package glint.render;

import glint.color.Rgb;
import glint.math.BadValueException;
import glint.scene.Prepared;
import glint.trace.RayTree;
import glint.trace.Recorder;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.stream.Collectors;

/** Traces one pixel again as a render does, and tells how its value comes about. */
public final class Replay {

  /**
   * A sample of the pixel; immutable.
   *
   * @param number in the pixel's sequence, from 0
   * @param x its place in the pixel, 0 to 1 from the left
   * @param y 0 to 1 from the top
   * @param tree its camera ray, and what came of that
   */
  public record Sample(int number, double x, double y, RayTree tree) {}

  private record Distance(int number, double value) {}

  private static final Comparator<Distance> NEARER =
      Comparator.comparingDouble(Distance::value)
          .thenComparing(Comparator.comparingInt(Distance::number).reversed());

  private final Prepared scene;
  private final RenderSettings settings;
  private final int column;
  private final int row;
  private final Rgb value;
  private final int invalid;

  /**
   * Traces all samples of a pixel.
   *
   * @throws BadValueException if the pixel is outside of the image
   */
  public Replay(Prepared scene, RenderSettings settings, int column, int row) {
    this.scene = scene;
    this.settings = settings;
    this.column = column;
    this.row = row;
    settings.requirePixel(column, row);
    PixelSampler samples = new PixelSampler(scene, settings, null);
    samples.begin(column, row);
    for (int i = 0; i < settings.samples(); i++) {
      samples.add(i);
    }
    value = samples.valid() == 0 ? Rgb.BLACK : mean(samples);
    invalid = settings.samples() - samples.valid();
  }

  /** Returns the pixel's linear value, bit for bit that of the image. */
  public Rgb value() {
    return value;
  }

  /** Returns how many samples are not finite and left out of the mean. */
  public int invalid() {
    return invalid;
  }

  /** Traces a sample, from 0, again and writes down all that happens. */
  public Sample sample(int number) {
    Recorder recorder = new Recorder();
    PixelSampler samples = new PixelSampler(scene, settings, recorder);
    samples.begin(column, row);
    samples.add(number);
    return new Sample(number, samples.probe().placeX(), samples.probe().placeY(), recorder.tree());
  }

  /**
   * Returns the numbers of the samples that are farthest, in any channel, from the pixel's value,
   * the farthest first; what is not finite is farthest of all.
   */
  public List<Integer> farthest(int most) {
    PriorityQueue<Distance> queue = new PriorityQueue<>(NEARER);
    PixelSampler samples = new PixelSampler(scene, settings, null);
    for (int i = 0; i < settings.samples(); i++) {
      samples.begin(column, row);
      boolean finite = samples.add(i);
      queue.add(new Distance(i, finite ? distance(mean(samples)) : Double.POSITIVE_INFINITY));
      if (queue.size() > most) {
        queue.remove();
      }
    }
    return queue.stream()
        .sorted(NEARER.reversed())
        .map(Distance::number)
        .collect(Collectors.toList());
  }

  private double distance(Rgb sample) {
    double r = Math.abs(sample.r() - value.r());
    double g = Math.abs(sample.g() - value.g());
    return Math.max(Math.max(r, g), Math.abs(sample.b() - value.b()));
  }

  private static Rgb mean(PixelSampler samples) {
    return new Rgb(samples.r(), samples.g(), samples.b());
  }
}
