package glint.geometry;

import glint.math.Check;
import glint.math.Vector3d;

/** A sphere. */
public record Sphere(Vector3d center, double radius) implements Surface {

  /** Checks that the centre is finite and the radius positive. */
  public Sphere {
    Check.finite("center", center);
    Check.positive("radius", radius);
  }
}
