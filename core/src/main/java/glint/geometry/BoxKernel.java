package glint.geometry;

import glint.math.Vector3d;

/**
 * Ray against solid box: its least and greatest corner, and by how much rays leave it moved.
 *
 * <p>Slabs (Kay and Kajiya 1986) with the near and far face of an axis chosen by the sign of the
 * direction, so that a ray inside a face's plane needs no 0·∞.
 */
final class BoxKernel {

  /** How many doubles a box takes. */
  static final int SIZE = 7;

  private BoxKernel() {}

  /** Storing a moved point rounds by half an ulp of the coordinate; two ulp are safely outside. */
  static double[] pack(Vector3d min, Vector3d max) {
    double offset = 2 * 0x1p-52 * Math.max(min.maxAbs(), max.maxAbs());
    return new double[] {min.x(), min.y(), min.z(), max.x(), max.y(), max.z(), offset};
  }

  static void intersect(double[] data, int at, Ray ray, Hit hit, int id) {
    if (ray.dx == 0 || ray.dy == 0 || ray.dz == 0) {
      intersectStraight(data, at, ray, hit, id);
      return;
    }
    int x = below(ray.dx);
    int y = below(ray.dy);
    int z = below(ray.dz);
    long behind =
        opposite(data[at + 3 - x] - ray.ox, ray.dx)
            | opposite(data[at + 4 - y] - ray.oy, ray.dy)
            | opposite(data[at + 5 - z] - ray.oz, ray.dz);
    if (behind >= 0) {
      intersectAhead(data, at, ray, hit, id, x, y, z);
    }
  }

  /** Returns a number below zero where two numbers have opposite signs, and so their quotient. */
  private static long opposite(double a, double b) {
    return Double.doubleToRawLongBits(a) ^ Double.doubleToRawLongBits(b);
  }

  private static void intersectAhead(
      double[] data, int at, Ray ray, Hit hit, int id, int x, int y, int z) {
    double enterX = (data[at + x] - ray.ox) / ray.dx;
    double enterY = (data[at + 1 + y] - ray.oy) / ray.dy;
    double enterZ = (data[at + 2 + z] - ray.oz) / ray.dz;
    double leaveX = (data[at + 3 - x] - ray.ox) / ray.dx;
    double leaveY = (data[at + 4 - y] - ray.oy) / ray.dy;
    double leaveZ = (data[at + 5 - z] - ray.oz) / ray.dz;
    double near = Math.max(enterX, Math.max(enterY, enterZ));
    double far = Math.min(leaveX, Math.min(leaveY, leaveZ));
    if (near <= far && far > 0) {
      int nearFace = near == enterX ? x : near == enterY ? 1 + y : 2 + z;
      int farFace = far == leaveX ? 3 - x : far == leaveY ? 4 - y : 5 - z;
      hit.offerSolid(ray, near, far, id, nearFace, farFace);
    }
  }

  /** Returns where, after the near plane of an axis upwards, that downwards stands. */
  private static int below(double d) {
    return (int) (Double.doubleToRawLongBits(d) >> 63) & 3;
  }

  private static void intersectStraight(double[] data, int at, Ray ray, Hit hit, int id) {
    double near = Double.NEGATIVE_INFINITY;
    double far = Double.POSITIVE_INFINITY;
    int nearFace = 0;
    int farFace = 0;
    for (int axis = 0; axis < 3; axis++) {
      double o = axis == 0 ? ray.ox : axis == 1 ? ray.oy : ray.oz;
      double d = axis == 0 ? ray.dx : axis == 1 ? ray.dy : ray.dz;
      double min = data[at + axis];
      double max = data[at + 3 + axis];
      if (d == 0) {
        if (!(o >= min && o <= max)) {
          return;
        }
      } else {
        boolean up = d > 0;
        double enter = ((up ? min : max) - o) / d;
        double leave = ((up ? max : min) - o) / d;
        if (enter > near) {
          near = enter;
          nearFace = up ? axis : 3 + axis;
        }
        if (leave < far) {
          far = leave;
          farFace = up ? 3 + axis : axis;
        }
      }
    }
    if (near <= far) {
      hit.offerSolid(ray, near, far, id, nearFace, farFace);
    }
  }

  /** Puts the point onto the face that was hit, exactly. */
  static void resolve(double[] data, int at, Ray ray, Hit hit) {
    int face = (int) hit.u;
    hit.px = within(data, at, ray.ox + hit.t * ray.dx);
    hit.py = within(data, at + 1, ray.oy + hit.t * ray.dy);
    hit.pz = within(data, at + 2, ray.oz + hit.t * ray.dz);
    double outward = face < 3 ? -1 : 1;
    hit.nx = 0;
    hit.ny = 0;
    hit.nz = 0;
    switch (face % 3) {
      case 0 -> {
        hit.px = data[at + face];
        hit.nx = outward;
      }
      case 1 -> {
        hit.py = data[at + face];
        hit.ny = outward;
      }
      default -> {
        hit.pz = data[at + face];
        hit.nz = outward;
      }
    }
    hit.offset = data[at + 6];
  }

  private static double within(double[] data, int at, double x) {
    return Math.min(Math.max(x, data[at]), data[at + 3]);
  }
}
