package glint.render;

import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.sampling.SobolSampler;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.View;
import glint.trace.Print;
import glint.trace.RayCounts;
import glint.trace.Recorder;
import glint.trace.Sight;
import glint.trace.Tracer;
import glint.trace.Veil;

/** Traces rays through places of the image; one per thread. */
final class Probe {

  /** The pair of numbers of which the first is the time. */
  private static final long TIME = -3;

  private final Prepared scene;
  private final View view;
  private final Tracer tracer;
  private final SobolSampler numbers;
  private final Ray ray = new Ray();
  private final int width;
  private final PixelWatch watch;
  private final boolean lens;
  private final boolean motion;
  private int left;
  private int top;
  private long invalid;
  private int invalidPixel = Integer.MAX_VALUE;
  private long reported;

  /**
   * Sets up a probe.
   *
   * @param recorder is told of every ray, if not null
   */
  Probe(Prepared scene, RenderSettings settings, Recorder recorder) {
    this(scene, settings, recorder, null);
  }

  /** Sets up a probe that nobody watches. */
  Probe(Prepared scene, RenderSettings settings) {
    this(scene, settings, null, null);
  }

  /** Sets up a probe that a watch, if not null, is told of. */
  Probe(Prepared scene, RenderSettings settings, PixelWatch watch) {
    this(scene, settings, watch == null ? null : watch.recorder, watch);
  }

  private Probe(Prepared scene, RenderSettings settings, Recorder recorder, PixelWatch watch) {
    this.watch = watch;
    this.scene = scene;
    view = new View(scene.scene().camera(), settings.width(), settings.height());
    int stated = scene.scene().maxDepth().orElse(RenderSettings.DEFAULT_DEPTH);
    int depth = settings.maxDepth().orElse(stated);
    numbers = new SobolSampler(settings.seed());
    tracer = new Tracer(scene, depth, settings.negligible(), recorder);
    width = settings.width();
    lens = scene.plan().lens().used();
    motion =
        scene.plan().motion().used()
            && scene.scene().placements().stream().anyMatch(Placement::isMoving);
  }

  /**
   * Traces the ray through a place, which leaves nothing to chance; returns whether its radiance is
   * finite and counts.
   *
   * @param x columns from the left edge of the image
   * @param y rows from its top edge
   */
  boolean trace(double x, double y) {
    numbers.centre();
    return traceSample(x, y);
  }

  /** Does the same, and finds out about shadows there. */
  boolean traceWatching(double x, double y) {
    tracer.watchesShadows = true;
    boolean finite = trace(x, y);
    tracer.watchesShadows = false;
    return finite;
  }

  /** Sets whether the next rays find out how what they meet is seen. */
  void watchSight(boolean watches) {
    tracer.watchesSight = watches;
  }

  /** Returns how the last ray saw what it met, if that was to be found out. */
  Sight sight() {
    return tracer.sight;
  }

  /** Turns to a pixel, whose samples are traced next. */
  void pixel(int column, int row) {
    left = column;
    top = row;
    numbers.pixel(column, row);
  }

  /** Traces a sample of the pixel, by its number; returns whether it is finite and counts. */
  boolean sample(int number) {
    turn(number);
    return traceSample(left + numbers.x, top + numbers.y);
  }

  /** Turns to a sample of the pixel, by its number. */
  void turn(int number) {
    numbers.sample(number);
  }

  /** Traces the sample at hand through a place of the image, like {@link #trace}. */
  boolean traceSample(double x, double y) {
    double end = lens ? view.ray(x, y, numbers, ray) : view.ray(x, y, ray);
    if (motion) {
      numbers.draw(TIME);
      ray.time = numbers.u;
    }
    if (watch != null) {
      watch.recorder.begin();
    }
    tracer.trace(ray, end, numbers);
    if (watch != null) {
      watch.saw(x, y);
    }
    boolean finite = Double.isFinite(tracer.r + tracer.g + tracer.b);
    if (!finite) {
      invalid++;
      int column = (int) Math.min(x, width - 1);
      int row = (int) y;
      invalidPixel = Math.min(invalidPixel, row * width + column);
    }
    return finite;
  }

  /** Returns the radiance of the last ray traced, by channel. */
  double r() {
    return tracer.r;
  }

  double g() {
    return tracer.g;
  }

  double b() {
    return tracer.b;
  }

  /** Returns a bound on what the last radiance leaves out, in any channel. */
  double cut() {
    return tracer.cut;
  }

  /** Returns where in its pixel the last sample was placed, 0 to 1 from the left. */
  double placeX() {
    return numbers.x;
  }

  /** Returns where in its pixel the last sample was placed, 0 to 1 from the top. */
  double placeY() {
    return numbers.y;
  }

  /** Returns whether the last ray, or one that came of it, was a random one of many. */
  boolean isRandom() {
    return numbers.hasDrawn();
  }

  /** Returns what the last ray met, in one number. */
  long signature() {
    return tracer.signature();
  }

  /** Returns the image on what the last ray met first. */
  Print print() {
    return tracer.print;
  }

  /** Returns where in the other images that it met the last ray looked, in their pixels. */
  double imageX() {
    return tracer.imageX();
  }

  double imageY() {
    return tracer.imageY();
  }

  /** Returns what the last ray met first, as in {@link Tracer#first}. */
  int first() {
    return tracer.first;
  }

  /** Returns what casts shadows on what the last ray met, as in {@link Veil#casters}. */
  long casters() {
    return tracer.veil.casters();
  }

  /** Returns by how much shadows darken what the last ray met: the square, in levels². */
  double kept(LevelScale scale) {
    double sum = scale.squaredDifference(tracer.r + tracer.veil.r, tracer.r);
    sum += scale.squaredDifference(tracer.g + tracer.veil.g, tracer.g);
    return (sum + scale.squaredDifference(tracer.b + tracer.veil.b, tracer.b)) / 3;
  }

  /** Returns what is traced. */
  Prepared scene() {
    return scene;
  }

  /** Returns how places in the image and points in the world belong together. */
  View view() {
    return view;
  }

  /** Sets a ray through a place; returns what it sees first. */
  Hit look(double x, double y, Ray out) {
    double end = view.ray(x, y, out);
    out.time = 0.5;
    return tracer.look(out, end);
  }

  /** Returns how many rays had a radiance that is not finite. */
  long invalid() {
    return invalid;
  }

  /** Returns the number, in row order, of the first pixel with such a ray, if any. */
  int invalidPixel() {
    return invalidPixel;
  }

  /** Returns how many rays of all kinds were traced since the last call. */
  long newRays() {
    long before = reported;
    reported = tracer.counts().total();
    return reported - before;
  }

  RayCounts counts() {
    return tracer.counts();
  }
}
