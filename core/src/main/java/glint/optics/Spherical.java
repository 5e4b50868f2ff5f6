package glint.optics;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Vector3d;

/**
 * An image around a point, as a map lies on a globe: u is the longitude, v the latitude; immutable.
 *
 * @param up to where the upper edge lies; of length 1 as the next, and all three square
 * @param front to where the middle lies
 * @param right to where the image's right half lies, at its middle
 */
public record Spherical(Vector3d center, Vector3d up, Vector3d front, Vector3d right)
    implements Mapping {

  /** The way of a globe whose front is z and whose north is y. */
  public static Spherical around(Vector3d center) {
    return of(center, new Vector3d(0, 1, 0), new Vector3d(0, 0, 1));
  }

  /**
   * Lays an image around a point.
   *
   * @param up to where its upper edge lies
   * @param front to where its middle lies, as far as that is square to up
   * @throws BadValueException if a number is not finite or the directions are parallel
   */
  public static Spherical of(Vector3d center, Vector3d up, Vector3d front) {
    Check.finite("center", center);
    Check.direction("up", up);
    Check.direction("front", front);
    Vector3d y = up.normalized();
    Vector3d x = y.cross(front.normalized());
    if (x.maxAbs() == 0) {
      throw new BadValueException("front", "must not lie along up, which is " + up);
    }
    Vector3d right = x.normalized();
    return new Spherical(center, y, right.cross(y), right);
  }

  @Override
  public void find(double px, double py, double pz, int flat, Texel texel) {
    double dx = px - center.x();
    double dy = py - center.y();
    double dz = pz - center.z();
    double x = dx * right.x() + dy * right.y() + dz * right.z();
    double y = dx * up.x() + dy * up.y() + dz * up.z();
    double z = dx * front.x() + dy * front.y() + dz * front.z();
    texel.u = 0.5 + StrictMath.atan2(x, z) / (2 * Math.PI);
    texel.v = 0.5 + StrictMath.atan2(y, Math.sqrt(x * x + z * z)) / Math.PI;
  }
}
