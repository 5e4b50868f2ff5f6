package glint.geometry;

import glint.math.Check;
import glint.math.Vector3d;

/** An unbounded plane through {@code point}, square to {@code normal} (any length but zero). */
public record Plane(Vector3d point, Vector3d normal) implements Surface {

  /** Checks that the point is finite and the normal is a direction. */
  public Plane {
    Check.finite("point", point);
    Check.direction("normal", normal);
  }
}
