package glint.geometry;

import glint.math.Vector3d;

/**
 * Ray against sphere: centre and radius.
 *
 * <p>Source: Haines, Günther, Akenine-Möller, Precision Improvements for Ray/Sphere Intersection,
 * Ray Tracing Gems (2019), chapter 7. The discriminant comes from the distance of the centre to the
 * line, not from b² - ac, which loses every digit for small or far spheres.
 */
final class SphereKernel {

  /** How many doubles a sphere takes. */
  static final int SIZE = 4;

  private SphereKernel() {}

  static double[] pack(Vector3d center, double radius) {
    return new double[] {center.x(), center.y(), center.z(), radius};
  }

  static void bounds(double[] data, int at, double[] out) {
    for (int axis = 0; axis < 3; axis++) {
      out[axis] = data[at + axis] - data[at + 3];
      out[3 + axis] = data[at + axis] + data[at + 3];
    }
  }

  static void intersect(double[] data, int at, Ray ray, Hit hit, int id) {
    double fx = ray.ox - data[at];
    double fy = ray.oy - data[at + 1];
    double fz = ray.oz - data[at + 2];
    double r = data[at + 3];
    double a = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
    double b = fx * ray.dx + fy * ray.dy + fz * ray.dz;
    double c = fx * fx + fy * fy + fz * fz - r * r;
    if (b > 0 && c > 0) { // begins outside and leads away: both roots are below zero
      return;
    }

    // Compute the foot of the perpendicular from the centre to the line, relative to the centre.
    double s = b / a;
    double lx = fx - s * ray.dx;
    double ly = fy - s * ray.dy;
    double lz = fz - s * ray.dz;
    double discriminant = a * (r * r - (lx * lx + ly * ly + lz * lz));
    if (!(discriminant >= 0)) {
      return;
    }

    // Compute both roots without cancellation.
    double root = Math.sqrt(discriminant);
    double near;
    double far;
    if (b > 0) {
      double q = -b - root;
      near = q / a;
      far = c / q;
    } else {
      double q = -b + root;
      near = c / q;
      far = q / a;
    }
    hit.offerSolid(ray, near, far, id, 0, 0);
  }

  /** Projects the point onto the sphere; the offset bounds its rounding (see docs/numerics.md). */
  static void resolve(double[] data, int at, Ray ray, Hit hit) {
    hit.curved = true;
    double cx = data[at];
    double cy = data[at + 1];
    double cz = data[at + 2];
    double r = data[at + 3];
    double x = ray.ox - cx + hit.t * ray.dx;
    double y = ray.oy - cy + hit.t * ray.dy;
    double z = ray.oz - cz + hit.t * ray.dz;
    if (x == 0 && y == 0 && z == 0) { // from so far that rounding leaves only the centre
      hit.setNormal(-ray.dx, -ray.dy, -ray.dz);
    } else {
      hit.setNormal(x, y, z);
    }
    hit.px = cx + r * hit.nx;
    hit.py = cy + r * hit.ny;
    hit.pz = cz + r * hit.nz;
    hit.offset = 4 * 0x1p-52 * (Math.abs(cx) + Math.abs(cy) + Math.abs(cz) + 4 * r);
  }
}
