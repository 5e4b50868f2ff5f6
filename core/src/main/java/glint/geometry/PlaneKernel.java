package glint.geometry;

import glint.math.Vector3d;

/** Ray against unbounded plane: a point of it and its unit normal. */
final class PlaneKernel {

  /** How many doubles a plane takes. */
  static final int SIZE = 6;

  private PlaneKernel() {}

  static double[] pack(Vector3d point, Vector3d normal) {
    Vector3d n = normal.normalized();
    return new double[] {point.x(), point.y(), point.z(), n.x(), n.y(), n.z()};
  }

  static void intersect(double[] data, int at, Ray ray, Hit hit, int id) {
    double nx = data[at + 3];
    double ny = data[at + 4];
    double nz = data[at + 5];
    double along = ray.dx * nx + ray.dy * ny + ray.dz * nz;
    double distance =
        (data[at] - ray.ox) * nx + (data[at + 1] - ray.oy) * ny + (data[at + 2] - ray.oz) * nz;
    if (along != 0) {
      hit.offer(ray, distance / along, id, along < 0 ? 1 : -1, 0, 0);
    }
  }

  /**
   * Projects the point onto the plane.
   *
   * <p>With q the plane's point, the signed distance s = (p - q)·n is computed to within 4u|p -
   * q|₁, here and again when a ray leaves, and storing p rounds by u|p|₁ twice: at most 10u(|p|₁ +
   * |q|₁) = 5·2⁻⁵²(|p|₁ + |q|₁) in all, taken as 8·2⁻⁵².
   */
  static void resolve(double[] data, int at, Ray ray, Hit hit) {
    double nx = data[at + 3];
    double ny = data[at + 4];
    double nz = data[at + 5];
    double x = ray.ox + hit.t * ray.dx;
    double y = ray.oy + hit.t * ray.dy;
    double z = ray.oz + hit.t * ray.dz;
    double s = (x - data[at]) * nx + (y - data[at + 1]) * ny + (z - data[at + 2]) * nz;
    hit.px = x - s * nx;
    hit.py = y - s * ny;
    hit.pz = z - s * nz;
    hit.nx = nx;
    hit.ny = ny;
    hit.nz = nz;
    double point = Math.abs(hit.px) + Math.abs(hit.py) + Math.abs(hit.pz);
    double anchor = Math.abs(data[at]) + Math.abs(data[at + 1]) + Math.abs(data[at + 2]);
    hit.offset = 8 * 0x1p-52 * (point + anchor);
  }
}
