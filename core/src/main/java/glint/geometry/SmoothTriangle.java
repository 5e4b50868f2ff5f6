package glint.geometry;

import glint.math.Rounding;
import glint.math.Transform;

/**
 * The curved surface that a triangle with normals at its corners stands for, at one hit.
 *
 * <p>Its normal is interpolated from the corners (Phong 1975). Its point is the hit's, moved onto
 * the tangent planes of the corners above it, interpolated likewise: shadow rays that leave from
 * there do not find the triangle's own flatness (J. Hanika, Hacking the Shadow Terminator, Ray
 * Tracing Gems II, ch. 4). Both are found in object space and carried into the world.
 */
final class SmoothTriangle {

  /** A sum of three unit vectors below this is rounding. */
  private static final double NOTHING = Rounding.gamma(8);

  private SmoothTriangle() {}

  /** Sets shading normal and lift of a hit that was faced. */
  static void shade(
      double[] points,
      int[] corners,
      CornerValues normals,
      int triangle,
      Transform toWorld,
      Hit hit) {
    int first = 3 * triangle;
    // Face the corners' normals as the hit's: some models have them point inwards.
    double side = hit.side * outward(points, corners, normals, first);
    double w = 1 - hit.u - hit.v;
    double px = interpolated(points, corners, first, 0, hit.u, hit.v, w);
    double py = interpolated(points, corners, first, 1, hit.u, hit.v, w);
    double pz = interpolated(points, corners, first, 2, hit.u, hit.v, w);
    double nx = 0;
    double ny = 0;
    double nz = 0;
    double x = 0;
    double y = 0;
    double z = 0;
    for (int i = 0; i < 3; i++) {
      double share = i == 0 ? hit.u : i == 1 ? hit.v : w;
      double cx = side * normals.of(first + i, 0);
      double cy = side * normals.of(first + i, 1);
      double cz = side * normals.of(first + i, 2);
      int at = 3 * corners[first + i];
      double above =
          cx * (points[at] - px) + cy * (points[at + 1] - py) + cz * (points[at + 2] - pz);
      double lift = share * Math.max(0, above);
      nx += share * cx;
      ny += share * cy;
      nz += share * cz;
      x += lift * cx;
      y += lift * cy;
      z += lift * cz;
    }
    if (Math.max(Math.abs(nx), Math.max(Math.abs(ny), Math.abs(nz))) > NOTHING) {
      toWorld.copyTo(hit.numbers);
      TransformedKernel.shadingToWorld(hit.numbers, nx, ny, nz, x, y, z, hit);
    }
  }

  /** Returns 1 if the normals of a triangle's corners, summed up, point outwards, else -1. */
  private static double outward(double[] points, int[] corners, CornerValues normals, int first) {
    double along = 0;
    for (int axis = 0; axis < 3; axis++) {
      int i = (axis + 1) % 3;
      int j = (axis + 2) % 3;
      double face =
          edge(points, corners, first, 1, i) * edge(points, corners, first, 2, j)
              - edge(points, corners, first, 1, j) * edge(points, corners, first, 2, i);
      double sum =
          normals.of(first, axis) + normals.of(first + 1, axis) + normals.of(first + 2, axis);
      along += face * sum;
    }
    return along < 0 ? -1 : 1;
  }

  private static double edge(double[] points, int[] corners, int first, int corner, int axis) {
    return points[3 * corners[first + corner] + axis] - points[3 * corners[first] + axis];
  }

  private static double interpolated(
      double[] points, int[] corners, int first, int axis, double u, double v, double w) {
    return u * points[3 * corners[first] + axis]
        + v * points[3 * corners[first + 1] + axis]
        + w * points[3 * corners[first + 2] + axis];
  }
}
