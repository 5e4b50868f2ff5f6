package glint.render;

import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.scene.Prepared;
import glint.scene.View;
import glint.trace.RayCounts;
import glint.trace.Recorder;
import glint.trace.Tracer;

/** Traces the samples of one pixel after another and takes their mean; one per thread. */
final class PixelSampler {

  private final boolean centred;
  private final View view;
  private final Tracer tracer;
  private final SobolSampler places;
  private final Ray ray = new Ray();
  private int column;
  private int row;
  private double r;
  private double g;
  private double b;
  private double cut;
  private int valid;

  /**
   * Sets up the samples that a render takes.
   *
   * @param recorder is told of every ray, if not null
   */
  PixelSampler(Prepared scene, RenderSettings settings, Recorder recorder) {
    centred = settings.samples() == 1;
    view = new View(scene.scene().camera(), settings.width(), settings.height());
    int stated = scene.scene().maxDepth().orElse(RenderSettings.DEFAULT_DEPTH);
    int depth = settings.maxDepth().orElse(stated);
    tracer = new Tracer(scene, depth, settings.negligible(), recorder);
    places = new SobolSampler(settings.seed());
  }

  /** Turns to a pixel that has no samples yet. */
  void begin(int x, int y) {
    column = x;
    row = y;
    r = 0;
    g = 0;
    b = 0;
    cut = 0;
    valid = 0;
    places.pixel(x, y);
  }

  /** Traces a sample of the pixel; returns whether it is finite and counts. */
  boolean add(int index) {
    place(index);
    double end = view.ray(column + places.x, row + places.y, ray);
    tracer.trace(ray, end);
    if (!Double.isFinite(tracer.r + tracer.g + tracer.b)) {
      return false;
    }
    r += tracer.r;
    g += tracer.g;
    b += tracer.b;
    cut += tracer.cut;
    valid++;
    return true;
  }

  /** Places a sample; a single one sits in the pixel's centre. */
  private void place(int index) {
    if (centred) {
      places.x = 0.5;
      places.y = 0.5;
    } else {
      places.sample(index);
    }
  }

  /** Returns how many samples of the pixel count. */
  int valid() {
    return valid;
  }

  /** Returns the mean of the samples that count, of which there is one at least. */
  double r() {
    return r / valid;
  }

  double g() {
    return g / valid;
  }

  double b() {
    return b / valid;
  }

  /** Returns a bound on what the mean leaves out, in any channel. */
  double cut() {
    return cut / valid;
  }

  /** Sets a ray through the pixel's centre; returns what it sees first. */
  Hit look(Ray out) {
    double end = view.ray(column + 0.5, row + 0.5, out);
    return tracer.look(out, end);
  }

  /** Returns where in the pixel the last sample was placed, 0 to 1 from the left. */
  double placeX() {
    return places.x;
  }

  /** Returns where in the pixel the last sample was placed, 0 to 1 from the top. */
  double placeY() {
    return places.y;
  }

  RayCounts counts() {
    return tracer.counts();
  }
}
