package glint.render;

import glint.image.Image;
import glint.scene.Prepared;
import java.util.function.BooleanSupplier;

/** Everything that one thread needs to sample pixels, made once and used for every tile. */
final class Worker {

  private final int samples;
  private final Image image;
  private final double[] cut;
  private final Looker looker;
  private final BooleanSupplier cancelled;
  private final PixelSampler sampler;

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
      Looker looker,
      BooleanSupplier cancelled) {
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
    for (int i = 0; i < samples; i++) {
      if (cancelled.getAsBoolean()) {
        return;
      }
      sampler.add(i);
    }
    if (sampler.valid() > 0) {
      image.set(x, y, sampler.r(), sampler.g(), sampler.b());
      cut[y * image.width() + x] = sampler.cut();
    }
    looker.look(sampler.probe(), x, y);
  }
}
