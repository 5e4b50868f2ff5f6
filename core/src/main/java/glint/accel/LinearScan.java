package glint.accel;

import glint.geometry.Hit;
import glint.geometry.Primitives;
import glint.geometry.Ray;

/** Finds hits by trying every primitive: the fastest way for a handful, and the reference. */
public final class LinearScan {

  private final Primitives primitives;

  /** Scans these primitives. */
  public LinearScan(Primitives primitives) {
    this.primitives = primitives;
  }

  /**
   * Finds the hit with the least t in {@code (ray.tMin, tMax]}; equal ones go to the lower number.
   *
   * @param local scratch for rays in object space
   */
  public void closest(Ray ray, double tMax, Hit hit, Ray local) {
    hit.begin(tMax);
    for (int id = 0; id < primitives.count(); id++) {
      primitives.intersect(id, ray, hit, local);
    }
  }

  /**
   * Returns whether anything is hit in {@code (ray.tMin, tMax]}; leaves some hit in the scratch.
   */
  public boolean any(Ray ray, double tMax, Hit scratch, Ray local) {
    scratch.begin(tMax);
    for (int id = 0; id < primitives.count() && !scratch.found(); id++) {
      primitives.intersect(id, ray, scratch, local);
    }
    return scratch.found();
  }
}
