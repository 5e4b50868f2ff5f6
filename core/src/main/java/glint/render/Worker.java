package glint.render;

import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.image.Image;
import glint.optics.Material;
import glint.scene.Prepared;
import glint.scene.View;
import glint.trace.RayCounts;
import glint.trace.Tracer;
import java.util.Map;

/** Everything that one thread needs to render pixels, made once and used for every tile. */
final class Worker {

  /** The radiance below which a bounce is not followed: a twentieth of a display level at white. */
  private static final double NEGLIGIBLE = 0.05 / 255;

  /** The same where the user states the depth: far below what any image shows. */
  private static final double EXACT = 0x1p-40;

  /** For every pixel a bound on the radiance that was not followed, any channel. */
  private final double[] cut;

  private final Renderer renderer;
  private final Prepared scene;
  private final RenderSettings settings;
  private final Image image;
  private final Map<Aov, Image> aovs;
  private final View view;
  private final Tracer tracer;
  private final SobolSampler sampler;
  private final Ray ray = new Ray();
  private long invalid;
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
    view = new View(scene.scene().camera(), settings.width(), settings.height());
    int stated = scene.scene().maxDepth().orElse(RenderSettings.DEFAULT_DEPTH);
    double negligible = settings.maxDepth().isPresent() ? EXACT : NEGLIGIBLE;
    tracer = new Tracer(scene, settings.maxDepth().orElse(stated), negligible);
    sampler = new SobolSampler(settings.seed());
  }

  RayCounts counts() {
    return tracer.counts();
  }

  /** Returns the rays traced since the last call. */
  long newRays() {
    long before = reported;
    reported = tracer.counts().total();
    return reported - before;
  }

  long invalid() {
    return invalid;
  }

  /**
   * Stores the mean of a pixel's samples, and what its centre sees first if that is asked for;
   * leaves it as it is when the render is cancelled.
   */
  void pixel(int x, int y) {
    double r = 0;
    double g = 0;
    double b = 0;
    double left = 0;
    int valid = 0;
    sampler.pixel(x, y);
    for (int i = 0; i < settings.samples(); i++) {
      if (renderer.isCancelled()) {
        return;
      }
      place(i);
      double end = view.ray(x + sampler.x, y + sampler.y, ray);
      tracer.trace(ray, end);
      if (Double.isFinite(tracer.r + tracer.g + tracer.b)) {
        r += tracer.r;
        g += tracer.g;
        b += tracer.b;
        left += tracer.cut;
        valid++;
      } else {
        invalid++;
      }
    }
    if (valid > 0) {
      image.set(x, y, r / valid, g / valid, b / valid);
      cut[y * settings.width() + x] = left / valid;
    }
    if (!aovs.isEmpty()) {
      look(x, y);
    }
  }

  /** Places a sample; a single one sits in the pixel's centre. */
  private void place(int index) {
    if (settings.samples() == 1) {
      sampler.x = 0.5;
      sampler.y = 0.5;
    } else {
      sampler.sample(index);
    }
  }

  private void look(int x, int y) {
    double end = view.ray(x + 0.5, y + 0.5, ray);
    double dx = ray.dx;
    double dy = ray.dy;
    double dz = ray.dz;
    Hit hit = tracer.look(ray, end);
    for (Map.Entry<Aov, Image> aov : aovs.entrySet()) {
      Image target = aov.getValue();
      switch (aov.getKey()) {
        case DEPTH -> grey(target, x, y, hit.found() ? hit.t : Double.POSITIVE_INFINITY);
        case ID -> grey(target, x, y, hit.found() ? hit.surface : -1);
        case NORMAL -> {
          if (hit.found()) {
            double side = dx * hit.nx + dy * hit.ny + dz * hit.nz > 0 ? -1 : 1;
            target.set(x, y, side * hit.nx, side * hit.ny, side * hit.nz);
          }
        }
        case ALBEDO -> {
          if (hit.found()) {
            Material m = scene.material(hit.surface);
            target.set(x, y, m.diffuse().r(), m.diffuse().g(), m.diffuse().b());
          }
        }
      }
    }
  }

  private static void grey(Image target, int x, int y, double v) {
    target.set(x, y, v, v, v);
  }
}
