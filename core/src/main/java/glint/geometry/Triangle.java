package glint.geometry;

import glint.math.Check;
import glint.math.Vector3d;

/** A triangle, visible from both sides; one without area is never hit. */
public record Triangle(Vector3d a, Vector3d b, Vector3d c) implements Surface {

  /** Checks that the corners are finite. */
  public Triangle {
    Check.finite("vertex 1", a);
    Check.finite("vertex 2", b);
    Check.finite("vertex 3", c);
  }
}
