package glint.trace;

import glint.accel.Intersector;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.math.Vector3d;
import glint.scene.Prepared;

/**
 * Finds the media that a camera ray starts in: those at the eye, and then what it goes in and out
 * of on the way from the eye to where the ray begins, and along the ray up to the near clipping
 * plane.
 */
final class StartMedia {

  private final Prepared scene;
  private final Intersector intersector;
  private final Boundary boundary;
  private final Hit eye = new Hit();
  private final Hit hit = new Hit();
  private final Ray way = new Ray();

  StartMedia(Prepared scene, Intersector intersector) {
    this.scene = scene;
    this.intersector = intersector;
    boundary = new Boundary(scene, intersector);
    Vector3d position = scene.scene().camera().position();
    eye.px = position.x();
    eye.py = position.y();
    eye.pz = position.z();
  }

  /**
   * Finds the media.
   *
   * @param ray starts at its {@code tMin}
   * @param interior empty; takes what is found
   */
  void find(Ray ray, Interior interior) {
    for (int medium : scene.mediaAtEye()) {
      interior.enter(medium);
    }
    eye.time = ray.time;
    if (ray.ox != eye.px || ray.oy != eye.py || ray.oz != eye.pz) {
      walk(eye.spawnTo(ray.ox, ray.oy, ray.oz, way), interior);
    }
    if (ray.tMin > 0) {
      way.copy(ray);
      way.tMin = 0;
      walk(ray.tMin, interior);
    }
  }

  /** Crosses everything up to the end of the way; what is opaque does not stop it. */
  private void walk(double end, Interior interior) {
    for (intersector.closest(way, end, hit); hit.found(); intersector.closest(way, end, hit)) {
      intersector.resolve(way, hit);
      boundary.meet(way, end, hit, interior);
      if (boundary.opaque) {
        way.goOnAfter(hit);
      }
      interior.copy(boundary.beyond);
    }
  }
}
