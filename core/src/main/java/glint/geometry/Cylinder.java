package glint.geometry;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Vector3d;

/**
 * A round cylinder, cone or frustum between two points of its axis.
 *
 * @param base one end of the axis, where the radius is {@code radius}
 * @param top the other end, where it is {@code topRadius} (0 for a cone's tip)
 * @param capped whether discs close the ends; an open one is seen from inside, too
 */
public record Cylinder(Vector3d base, Vector3d top, double radius, double topRadius, boolean capped)
    implements Surface {

  /** Checks that the axis has a length, and the radii are not negative nor both zero. */
  public Cylinder {
    Check.finite("base", base);
    Check.finite("top", top);
    if (base.equals(top)) {
      throw new BadValueException("top", "must differ from base, but both are " + base);
    }
    if (radius != 0 || topRadius == 0) {
      Check.positive("radius", radius);
    }
    if (topRadius != 0) {
      Check.positive("top_radius", topRadius);
    }
  }
}
