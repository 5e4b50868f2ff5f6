package glint.render;

import glint.image.Image;
import glint.scene.Prepared;
import java.util.function.BooleanSupplier;

/** Everything that one thread needs to sample pixels, made once and used for every tile. */
final class Worker {

  private final Image image;
  private final double[] cut;
  private final Looker looker;
  private final BooleanSupplier cancelled;
  private final PixelSampler sampler;
  private final Settling settling;
  private final int samples;
  private int taken;
  private final double[] levels = new double[3];

  /**
   * Sets up a worker.
   *
   * @param cut for every pixel a bound on the radiance that was not followed, any channel
   */
  Worker(
      Prepared scene,
      RenderSettings settings,
      Image image,
      double[] cut,
      Settling settling,
      Looker looker,
      BooleanSupplier cancelled) {
    this.settling = settling;
    samples = settings.samples();
    this.image = image;
    this.cut = cut;
    this.looker = looker;
    this.cancelled = cancelled;
    sampler = new PixelSampler(scene, settings, null);
  }

  Probe probe() {
    return sampler.probe();
  }

  /**
   * Stores the mean of a pixel's samples, and what its centre sees first if that is asked for;
   * leaves it as it is when the render is cancelled.
   */
  void pixel(int x, int y) {
    sampler.begin(x, y);
    taken = 0;
    int pixel = y * image.width() + x;
    if (settling.isNoted(pixel)) {
      for (int stage = 0; stage < Settling.STAGES; stage++) {
        sample(settling.end(stage));
        settling.note(stage, pixel, sampler, levels);
      }
    }
    sample(samples);
    if (cancelled.getAsBoolean()) {
      return;
    }
    if (sampler.valid() > 0) {
      image.set(x, y, sampler.r(), sampler.g(), sampler.b());
      cut[pixel] = sampler.cut();
    }
    looker.look(sampler.probe(), x, y);
  }

  /** Takes samples of the pixel until it has had so many. */
  private void sample(int end) {
    for (; taken < end && !cancelled.getAsBoolean(); taken++) {
      sampler.add(taken);
    }
  }
}
