package glint.render;

import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.image.Image;
import glint.scene.Prepared;
import glint.trace.RayCounts;
import java.util.Map;

/** Everything that one thread needs to render pixels, made once and used for every tile. */
final class Worker {

  /** For every pixel a bound on the radiance that was not followed, any channel. */
  private final double[] cut;

  private final Renderer renderer;
  private final Prepared scene;
  private final RenderSettings settings;
  private final Image image;
  private final Map<Aov, Image> aovs;
  private final PixelSampler samples;
  private final Ray ray = new Ray();
  private long invalid;
  private int invalidPixel = Integer.MAX_VALUE;
  private long reported;

  Worker(
      Renderer renderer,
      Prepared scene,
      RenderSettings settings,
      Image image,
      double[] cut,
      Map<Aov, Image> aovs) {
    this.cut = cut;
    this.renderer = renderer;
    this.scene = scene;
    this.settings = settings;
    this.image = image;
    this.aovs = aovs;
    samples = new PixelSampler(scene, settings, null);
  }

  RayCounts counts() {
    return samples.counts();
  }

  /** Returns the rays traced since the last call. */
  long newRays() {
    long before = reported;
    reported = samples.counts().total();
    return reported - before;
  }

  long invalid() {
    return invalid;
  }

  /** Returns the number, in row order, of the first pixel with an invalid sample, if any. */
  int invalidPixel() {
    return invalidPixel;
  }

  /**
   * Stores the mean of a pixel's samples, and what its centre sees first if that is asked for;
   * leaves it as it is when the render is cancelled.
   */
  void pixel(int x, int y) {
    samples.begin(x, y);
    for (int i = 0; i < settings.samples(); i++) {
      if (renderer.isCancelled()) {
        return;
      }
      if (!samples.add(i)) {
        invalid++;
        invalidPixel = Math.min(invalidPixel, y * settings.width() + x);
      }
    }
    if (samples.valid() > 0) {
      image.set(x, y, samples.r(), samples.g(), samples.b());
      cut[y * settings.width() + x] = samples.cut();
    }
    if (!aovs.isEmpty()) {
      look(x, y);
    }
  }

  private void look(int x, int y) {
    Hit hit = samples.look(ray);
    double dx = ray.dx;
    double dy = ray.dy;
    double dz = ray.dz;
    for (Map.Entry<Aov, Image> aov : aovs.entrySet()) {
      Image target = aov.getValue();
      switch (aov.getKey()) {
        case DEPTH -> grey(target, x, y, hit.found() ? hit.t : Double.POSITIVE_INFINITY);
        case ID -> grey(target, x, y, hit.found() ? scene.place(hit.surface) : -1);
        case NORMAL -> {
          if (hit.found()) {
            double side = dx * hit.nx + dy * hit.ny + dz * hit.nz > 0 ? -1 : 1;
            target.set(x, y, side * hit.nx, side * hit.ny, side * hit.nz);
          }
        }
        case ALBEDO -> {
          if (hit.found()) {
            Rgb diffuse = scene.material(hit.surface).diffuse();
            Rgb pattern = scene.texture(hit.surface, hit);
            target.set(
                x,
                y,
                diffuse.r() * pattern.r(),
                diffuse.g() * pattern.g(),
                diffuse.b() * pattern.b());
          }
        }
      }
    }
  }

  private static void grey(Image target, int x, int y, double v) {
    target.set(x, y, v, v, v);
  }
}
