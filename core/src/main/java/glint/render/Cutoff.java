package glint.render;

import glint.scene.Prepared;

/** Finds how little a bounce may bring and still be followed, for an error that is accepted. */
final class Cutoff {

  /** The share of the accepted error that bounces not followed may take. */
  static final double SHARE = 0.05;

  /** Rays to try it with, in each direction of the image. */
  private static final int TRIALS = 32;

  /** To follow twice as much is worth one of so many parts of that share. */
  private static final double WORTH = 4;

  /** Less than this is never cut off: far below what any image shows. */
  private static final double LEAST = 0x1p-40;

  private Cutoff() {}

  /**
   * Returns the radiance below which a bounce is not followed, such that a sparse sample of the
   * image loses no more than its share of the error.
   *
   * <p>Where radiance has no bound, nothing is known of what is lost, and nothing to gain. What is
   * lost at the limit of bounces stays lost: it shows by how little is gained by following more.
   *
   * @param levels the error accepted; if 0, as if it were a tenth
   */
  static double find(Prepared scene, RenderSettings settings, double levels, LevelScale scale) {
    double accepted = levels > 0 ? levels : 0.1;
    double share = SHARE * accepted;
    double negligible = Math.min(settings.negligible(), accepted / 255);
    boolean bounded = scene.radianceBound() < Double.POSITIVE_INFINITY;
    double gained = Double.POSITIVE_INFINITY;
    boolean bounces = scene.plan().mirrors().used() || scene.plan().refraction().used();
    boolean tried = bounces && bounded && negligible > LEAST;
    double lost = tried ? lost(scene, settings.following(negligible), scale) : 0;
    while (lost > share && gained > share / WORTH && negligible > LEAST) {
      negligible /= 2;
      double less = lost(scene, settings.following(negligible), scale);
      gained = lost - less;
      lost = less;
    }
    return negligible;
  }

  /** Returns the RMS of what is lost at most, in levels. */
  private static double lost(Prepared scene, RenderSettings settings, LevelScale scale) {
    Probe probe = new Probe(scene, settings);
    int columns = Math.min(TRIALS, settings.width());
    int rows = Math.min(TRIALS, settings.height());
    double sum = 0;
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        double x = (column + 0.5) * settings.width() / columns;
        double y = (row + 0.5) * settings.height() / rows;
        if (probe.trace(x, y) && probe.cut() > 0) {
          sum += scale.squaredDifference(probe.r() + probe.cut(), probe.r());
          sum += scale.squaredDifference(probe.g() + probe.cut(), probe.g());
          sum += scale.squaredDifference(probe.b() + probe.cut(), probe.b());
        }
      }
    }
    return Math.sqrt(sum / (3.0 * rows * columns));
  }
}
