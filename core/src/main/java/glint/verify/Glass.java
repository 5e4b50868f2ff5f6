package glint.verify;

import glint.color.Rgb;
import glint.geometry.Ray;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import glint.trace.Tracer;

/** What cases of transparency are made of: clear materials, a field of light, single rays. */
final class Glass {

  /** Rays below this radiance are not followed: far below every tolerance. */
  static final double NEGLIGIBLE = 0x1p-50;

  private Glass() {}

  /** Returns a material that loses nothing at its surface. */
  static Material of(double ior, Rgb absorption, int priority) {
    Medium inside = new Medium(ior, absorption, priority);
    return new Material(
        Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK, Rgb.WHITE, inside);
  }

  static Material of(double ior) {
    return of(ior, Rgb.BLACK, 0);
  }

  /** Returns a mirror that gives light of its own. */
  static Material mirror(double reflection, double emission) {
    Rgb share = Rgb.grey(reflection);
    return new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, share, Rgb.grey(emission));
  }

  /** Begins a scene in a field of radiance 1, its eye far outside of everything. */
  static Scene.Builder field() {
    Projection lens = Projection.vertical(30);
    return new Scene.Builder("field")
        .size(16, 12)
        .camera(Camera.of(new Vector3d(0, 60, 80), Vector3d.ZERO, Pictures.UP, lens))
        .background(Background.constant(Rgb.WHITE));
  }

  /** Begins a scene in whose sky every direction up or down has its own radiance. */
  static Scene.Builder sky() {
    return field().background(new Background(Rgb.BLACK, Rgb.WHITE));
  }

  /** Returns a tracer that gives up nothing but what is too deep. */
  static Tracer tracer(Scene.Builder scene, int depth) {
    return new Tracer(Prepared.of(scene.build()), depth, NEGLIGIBLE);
  }

  /** Traces one ray and returns its red radiance. */
  static double red(Tracer tracer, Vector3d from, Vector3d direction) {
    Vector3d d = direction.normalized();
    Ray ray = new Ray();
    ray.set(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
    tracer.trace(ray, Double.POSITIVE_INFINITY);
    return tracer.r;
  }
}
