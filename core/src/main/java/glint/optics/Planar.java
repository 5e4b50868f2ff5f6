package glint.optics;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Vector3d;

/**
 * An image on a plane, seen through whatever lies before or behind; immutable.
 *
 * @param corner where its lower left corner lies
 * @param perU the vector whose product with the way from there is u
 * @param perV the same for v
 */
public record Planar(Vector3d corner, Vector3d perU, Vector3d perV) implements Mapping {

  /**
   * Lays an image along two edges, as if onto a quad.
   *
   * @param edge1 its lower edge, from left to right
   * @param edge2 its left edge, upwards
   * @throws BadValueException if a number is not finite or the edges span no area
   */
  public static Planar of(Vector3d corner, Vector3d edge1, Vector3d edge2) {
    Check.finite("corner", corner);
    Check.direction("edge1", edge1);
    Check.direction("edge2", edge2);
    if (edge1.normalized().cross(edge2.normalized()).maxAbs() == 0) {
      throw new BadValueException("edge2", "must not be parallel to edge1");
    }
    return along(corner, edge1, edge2);
  }

  /** Does the same for edges that are known to span an area. */
  public static Planar along(Vector3d corner, Vector3d edge1, Vector3d edge2) {
    Vector3d a = edge1.normalized();
    Vector3d b = edge2.normalized();
    Vector3d n = a.cross(b);
    // b × n is square to b, n × a to a, and both have the product n·n with the other.
    double scale = 1 / n.dot(n);
    Vector3d perU = b.cross(n).times(scale / edge1.dot(a));
    Vector3d perV = n.cross(a).times(scale / edge2.dot(b));
    return new Planar(corner, perU, perV);
  }

  @Override
  public void find(double x, double y, double z, int flat, Texel texel) {
    double dx = x - corner.x();
    double dy = y - corner.y();
    double dz = z - corner.z();
    texel.u = dx * perU.x() + dy * perU.y() + dz * perU.z();
    texel.v = dx * perV.x() + dy * perV.y() + dz * perV.z();
  }
}
