package glint.light;

import glint.accel.Intersector;
import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Primitives;
import glint.geometry.Ray;
import glint.math.Transform;

/**
 * Finds the lamps that rays see from their shining side; one per worker.
 *
 * <p>Lamps are not among the surfaces of a scene, so that none is in its own light's way.
 */
public final class LampSight {

  private final Illumination lights;
  private final Intersector intersector;
  private final Ray way = new Ray();
  private final Hit hit = new Hit();

  /** Sets up the search. */
  public LampSight(Illumination lights) {
    this.lights = lights;
    Primitives.Builder shapes = new Primitives.Builder();
    for (int i = 0; i < lights.count(); i++) {
      if (lights.shape(i) != null) {
        shapes.add(lights.shape(i), Transform.IDENTITY, i, false);
      }
    }
    intersector = new Intersector(shapes.build());
  }

  /** Finds the first lamp on a ray up to a parameter; returns whether there is one. */
  public boolean find(Ray ray, double end) {
    way.copy(ray);
    while (true) {
      intersector.closest(way, end, hit);
      if (!hit.found()) {
        return false;
      }
      intersector.resolve(way, hit);
      if (way.dx * hit.nx + way.dy * hit.ny + way.dz * hit.nz < 0) {
        return true;
      }
      way.goOnAfter(hit);
    }
  }

  /** Returns the parameter at which the lamp was found. */
  public double t() {
    return hit.t;
  }

  /** Returns which of the lights it is. */
  public int light() {
    return hit.surface;
  }

  /** Returns the radiance of the lamp that was found. */
  public Rgb radiance() {
    return lights.color(hit.surface);
  }
}
