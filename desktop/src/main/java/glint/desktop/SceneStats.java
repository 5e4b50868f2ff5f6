package glint.desktop;

import glint.image.Image;
import glint.render.Goal;
import glint.render.RenderSettings;
import glint.render.Statistics;
import glint.trace.RayCounts;

/**
 * The statistics of one rendered scene, in the order and under the names of the JSON that people
 * and scripts read; immutable.
 *
 * <p>All but the name and the size is null for a scene whose image was kept and holds no record.
 *
 * @param sha256 hash of the linear image: its doubles, big-endian, in row order, in hex
 * @param resumed whether the image was kept from an earlier run; its seconds are then 0
 */
record SceneStats(
    String name,
    int width,
    int height,
    Seconds seconds,
    Rays rays,
    Samples samples,
    Double raysPerSecond,
    Integer primitives,
    Geometry geometry,
    ErrorEstimate error,
    Depth depth,
    Long invalid,
    Long clipped,
    String sha256,
    boolean resumed) {

  /** Wall time by phase. */
  record Seconds(double load, double build, double render, double write) {
    static final Seconds NONE = new Seconds(0, 0, 0, 0);
  }

  /** Rays by kind. */
  record Rays(long camera, long reflection, long refraction, long shadow) {
    long total() {
      return camera + reflection + refraction + shadow;
    }
  }

  /** Samples of a pixel. */
  record Samples(int min, double mean, int max) {}

  /** What the flat arrays and the tree take in memory. */
  record Geometry(long bytes, double bytesPerPrimitive) {}

  /**
   * What is known of the error.
   *
   * @param estimate by sampling and by truncation together; null where files hold no record
   * @param target what was accepted; null if a number of samples, or only a time, was given
   * @param truncation what bounces not followed can add at most
   */
  record ErrorEstimate(Double estimate, Double target, Double truncation, String unit) {
    static ErrorEstimate of(Goal goal, Statistics s) {
      boolean aims = goal instanceof Goal.Error e && e.levels() > 0;
      return new ErrorEstimate(
          s.samplingError() + s.truncation(),
          aims ? ((Goal.Error) goal).levels() : null,
          s.truncation(),
          "levels");
    }

    static final ErrorEstimate UNKNOWN = new ErrorEstimate(null, null, null, "levels");
  }

  /** Successive bounces. */
  record Depth(int max) {}

  /** Returns the statistics of a scene that has just been rendered. */
  static SceneStats of(
      String name, RenderSettings settings, Seconds seconds, Statistics s, Image image) {
    RayCounts rays = s.rays();
    return new SceneStats(
        name,
        settings.width(),
        settings.height(),
        seconds,
        new Rays(rays.camera, rays.reflection, rays.refraction, rays.shadow),
        new Samples(s.minSamples(), s.meanSamples(), s.maxSamples()),
        rays.total() / seconds.render(),
        s.primitives(),
        new Geometry(s.geometryBytes(), (double) s.geometryBytes() / Math.max(1, s.primitives())),
        ErrorEstimate.of(settings.goal(), s),
        new Depth(rays.maxDepth),
        s.invalid(),
        s.clipped(),
        image.sha256(),
        false);
  }

  /** Returns the statistics of a kept scene whose files hold no record. */
  static SceneStats unrecorded(String name, RenderSettings settings) {
    return new SceneStats(
        name,
        settings.width(),
        settings.height(),
        Seconds.NONE,
        null,
        null,
        null,
        null,
        null,
        ErrorEstimate.UNKNOWN,
        null,
        null,
        null,
        null,
        true);
  }

  /** Returns the same, kept from an earlier run. */
  SceneStats kept() {
    return new SceneStats(
        name,
        width,
        height,
        Seconds.NONE,
        rays,
        samples,
        null,
        primitives,
        geometry,
        error,
        depth,
        invalid,
        clipped,
        sha256,
        true);
  }
}
