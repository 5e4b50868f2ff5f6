package glint.optics;

import glint.math.Vector3d;

/**
 * An image around an axis, as a label lies on a can: u is the angle, v the height; immutable. Each
 * of its caps shows all of the image, in the square around the disc.
 *
 * @param globe directions from the base: up along the axis, front and right
 * @param radius at the base
 * @param topRadius at the other end
 */
public record Around(Spherical globe, double height, double radius, double topRadius)
    implements Mapping {

  /** Lays an image around an axis; its middle is towards z, or y where the axis is nearest to z. */
  public static Around of(Vector3d base, Vector3d axis, double radius, double topRadius) {
    double z = Math.abs(axis.z());
    boolean alongZ = z > Math.abs(axis.x()) && z > Math.abs(axis.y());
    Vector3d front = alongZ ? new Vector3d(0, 1, 0) : new Vector3d(0, 0, 1);
    Spherical globe = Spherical.of(base, axis.normalized(), front);
    return new Around(globe, axis.dot(globe.up()), radius, topRadius);
  }

  @Override
  public void find(double px, double py, double pz, int flat, Texel texel) {
    double dx = px - globe.center().x();
    double dy = py - globe.center().y();
    double dz = pz - globe.center().z();
    Vector3d right = globe.right();
    Vector3d up = globe.up();
    Vector3d front = globe.front();
    double x = dx * right.x() + dy * right.y() + dz * right.z();
    double y = dx * up.x() + dy * up.y() + dz * up.z();
    double z = dx * front.x() + dy * front.y() + dz * front.z();
    if (flat == Pattern.SOLID) {
      texel.u = 0.5 + StrictMath.atan2(x, z) / (2 * Math.PI);
      texel.v = y / height;
      return;
    }
    boolean isTop = 2 * y > height;
    double across = 2 * (isTop ? topRadius : radius);
    texel.u = 0.5 + x / across;
    texel.v = 0.5 + (isTop ? -z : z) / across;
  }
}
