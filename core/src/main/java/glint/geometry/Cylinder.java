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

  /**
   * The most that the radius may change in a unit of height, lest its square times a length's
   * overflow.
   */
  private static final double FLATTEST = 1e50;

  /** Checks that the axis has a length, and the radii are not negative nor both zero. */
  public Cylinder {
    Check.finite("base", base);
    Check.finite("top", top);
    Vector3d axis = top.minus(base);
    if (axis.maxAbs() == 0) {
      throw new BadValueException("top", "must differ from base, but both are " + base);
    }
    double height = axis.dot(axis.normalized());
    if (height < Check.SMALLEST) {
      throw new BadValueException("top", "must be at least 1e-100 from base, but is " + height);
    }
    if (radius != 0 || topRadius == 0) {
      Check.positive("radius", radius);
    }
    if (topRadius != 0) {
      Check.positive("top_radius", topRadius);
    }
    if (Math.abs(topRadius - radius) > FLATTEST * height) {
      throw new BadValueException("top", "is too near to base for such radii: at " + height);
    }
  }
}
