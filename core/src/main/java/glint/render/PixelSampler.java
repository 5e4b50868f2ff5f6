package glint.render;

import glint.scene.Prepared;
import glint.trace.Recorder;

/** Traces the samples of one pixel after another and takes their mean; one per thread. */
final class PixelSampler {

  private final boolean centred;
  private final Probe probe;
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
    probe = new Probe(scene, settings, recorder);
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
    probe.pixel(x, y);
  }

  /**
   * Traces a sample of the pixel, a single one in its centre; returns whether it is finite and
   * counts.
   */
  boolean add(int index) {
    boolean counts = centred ? probe.trace(column + 0.5, row + 0.5) : probe.sample(index);
    if (!counts) {
      return false;
    }
    r += probe.r();
    g += probe.g();
    b += probe.b();
    cut += probe.cut();
    valid++;
    return true;
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

  Probe probe() {
    return probe;
  }
}
