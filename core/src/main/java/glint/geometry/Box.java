package glint.geometry;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Vector3d;

/** A box with faces square to the axes, from its least corner to its greatest. */
public record Box(Vector3d min, Vector3d max) implements Surface {

  /** Checks that both corners are finite and that min is below max on every axis. */
  public Box {
    Check.finite("min", min);
    Check.finite("max", max);
    if (!(min.x() < max.x() && min.y() < max.y() && min.z() < max.z())) {
      throw new BadValueException(
          "min", "must be below max on every axis, but is " + min + " with max " + max);
    }
  }
}
