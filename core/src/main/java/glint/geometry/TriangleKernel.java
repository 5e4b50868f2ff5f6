package glint.geometry;

import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;

/**
 * Ray against triangle: three corners.
 *
 * <p>Source: Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013. A corner
 * is sheared by itself, without regard to its triangle, and an edge function changes only its sign
 * when the edge is walked the other way; so two triangles that share an edge agree on which side of
 * it a ray passes, and no ray slips between them.
 */
final class TriangleKernel {

  /** How many doubles a triangle takes. */
  static final int SIZE = 9;

  private static final double GAMMA2 = Rounding.gamma(2);
  private static final double GAMMA3 = Rounding.gamma(3);
  private static final double GAMMA5 = Rounding.gamma(5);

  /**
   * A ray that leaves a triangle starts within 5·2^-52 times the sum of its largest coordinates:
   * one for the rounding of the hit point, four for the offset. Three times that is certainly not
   * there.
   */
  private static final double LEFT = 16 * 0x1p-52;

  private TriangleKernel() {}

  static double[] pack(Vector3d a, Vector3d b, Vector3d c) {
    return new double[] {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()};
  }

  static void bounds(double[] data, int at, double[] out) {
    for (int axis = 0; axis < 3; axis++) {
      double a = data[at + axis];
      double b = data[at + 3 + axis];
      double c = data[at + 6 + axis];
      out[axis] = Math.min(a, Math.min(b, c));
      out[3 + axis] = Math.max(a, Math.max(b, c));
    }
  }

  static void intersect(double[] data, int at, Ray ray, Hit hit, int id) {
    // Translate to the ray's origin and shear, so that the ray runs along the z axis.
    ray.shear();
    double az = data[at + ray.kz] - ray.okz;
    double bz = data[at + 3 + ray.kz] - ray.okz;
    double cz = data[at + 6 + ray.kz] - ray.okz;
    double ax = data[at + ray.kx] - ray.okx - ray.shearX * az;
    double ay = data[at + ray.ky] - ray.oky - ray.shearY * az;
    double bx = data[at + 3 + ray.kx] - ray.okx - ray.shearX * bz;
    double by = data[at + 3 + ray.ky] - ray.oky - ray.shearY * bz;
    double cx = data[at + 6 + ray.kx] - ray.okx - ray.shearX * cz;
    double cy = data[at + 6 + ray.ky] - ray.oky - ray.shearY * cz;

    // Compute the edge functions; edges and corners belong to the triangle.
    double u = cx * by - cy * bx;
    double v = ax * cy - ay * cx;
    double w = bx * ay - by * ax;
    if (areApart(u, v, w)) {
      return;
    }
    double det = u + v + w;
    if (det == 0) {
      return;
    }
    double t = (u * az + v * bz + w * cz) * ray.shearZ / det;
    if (!ray.reaches(t * ray.unit, id)) {
      return;
    }

    // Seen along the ray, the corners of the outside run the way that the sign of det says.
    int crossing = det > 0 == ray.shearZ > 0 ? 1 : -1;

    // Accept only what lies before the origin beyond all rounding (Pharr, Jakob, Humphreys,
    // Physically Based Rendering, 3rd ed., section 3.9.6).
    double maxZ = max(az, bz, cz);
    double maxX = max(ax, bx, cx);
    double maxY = max(ay, by, cy);
    double deltaX = GAMMA5 * (maxX + maxZ);
    double deltaY = GAMMA5 * (maxY + maxZ);
    double deltaE = 2 * (GAMMA2 * maxX * maxY + deltaY * maxX + deltaX * maxY);
    double maxE = max(u, v, w);
    double deltaZ = GAMMA3 * maxZ;
    double deltaT =
        3 * (GAMMA3 * maxE * maxZ + deltaE * maxZ + deltaZ * maxE) * Math.abs(ray.shearZ / det);
    t = withinBox(data, at, ray, GAMMA5 * (maxX + maxY + maxZ), t);
    if (t > deltaT) {
      hit.offer(ray, t, id, crossing, u / det, v / det);
      return;
    }

    // Seen so edge-on that rounding hides t, it still cannot be the surface that the ray leaves if
    // all of it lies ahead; its neighbours trust it to be hit, or a closed mesh would open here.
    double origin = Math.abs(ray.okx) + Math.abs(ray.oky) + Math.abs(ray.okz);
    double side = ray.shearZ > 0 ? 1 : -1;
    double nearest = Math.min(side * az, Math.min(side * bz, side * cz));
    boolean ahead = nearest > LEFT * (origin + maxX + maxY + 3 * maxZ);
    if (ahead && !isEdgeOn(data, at, ray)) {
      hit.offer(ray, t, id, crossing, u / det, v / det);
    }
  }

  /**
   * Returns whether of three numbers one is below zero and another above it.
   *
   * <p>Mostly the signs tell, in one branch: six, one for each comparison, would often be
   * mispredicted. A zero has a sign that says nothing.
   */
  private static boolean areApart(double u, double v, double w) {
    long first = Double.doubleToRawLongBits(u);
    long second = Double.doubleToRawLongBits(v);
    long third = Double.doubleToRawLongBits(w);
    if (((first ^ second) | (second ^ third)) >= 0) {
      return false;
    }
    boolean zero = u == 0 || v == 0 || w == 0;
    return !zero || ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0));
  }

  /**
   * Returns the parameter nearest to t at which the ray is within a distance of the triangle's box,
   * or 0 if it is nowhere.
   *
   * <p>Seen edge-on, the signs and the weights of the corners are rounding: t may be that of any
   * corner, and the ray may even pass beside the triangle. A tree would not look for it there. The
   * distance is that of {@code deltaX}: less than what a tree leaves around its boxes.
   */
  private static double withinBox(double[] data, int at, Ray ray, double distance, double t) {
    if (isWithin(data, at, ray.ox, t * ray.dx, distance)
        && isWithin(data, at + 1, ray.oy, t * ray.dy, distance)
        && isWithin(data, at + 2, ray.oz, t * ray.dz, distance)) {
      return t;
    }
    double enter = Double.NEGATIVE_INFINITY;
    double leave = Double.POSITIVE_INFINITY;
    for (int axis = 0; axis < 3; axis++) {
      double o = axis == 0 ? ray.ox : axis == 1 ? ray.oy : ray.oz;
      double d = axis == 0 ? ray.dx : axis == 1 ? ray.dy : ray.dz;
      double a = data[at + axis];
      double b = data[at + 3 + axis];
      double c = data[at + 6 + axis];
      double least = Math.min(a, Math.min(b, c)) - distance - o;
      double greatest = Math.max(a, Math.max(b, c)) + distance - o;
      if (d != 0) {
        enter = Math.max(enter, (d > 0 ? least : greatest) / d);
        leave = Math.min(leave, (d > 0 ? greatest : least) / d);
      } else if (least > 0 || greatest < 0) {
        return 0;
      }
    }
    return enter <= leave ? Math.min(Math.max(t, enter), leave) : 0;
  }

  /**
   * Returns whether a way from the origin along an axis ends within the box: if a rounded product
   * is strictly between two numbers, t is between their quotients by the direction, rounded or not.
   */
  private static boolean isWithin(double[] data, int at, double o, double way, double distance) {
    double a = data[at];
    double b = data[at + 3];
    double c = data[at + 6];
    return way > Math.min(a, Math.min(b, c)) - distance - o
        && way < Math.max(a, Math.max(b, c)) + distance - o;
  }

  /** Returns whether the ray's direction lies in the triangle's plane, by exact arithmetic. */
  private static boolean isEdgeOn(double[] data, int at, Ray ray) {
    BigDecimal[] p = new BigDecimal[3];
    BigDecimal[] q = new BigDecimal[3];
    for (int i = 0; i < 3; i++) {
      BigDecimal a = new BigDecimal(data[at + i]);
      p[i] = new BigDecimal(data[at + 3 + i]).subtract(a);
      q[i] = new BigDecimal(data[at + 6 + i]).subtract(a);
    }
    double[] d = {ray.dx, ray.dy, ray.dz};
    BigDecimal along = BigDecimal.ZERO;
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      BigDecimal normal = p[j].multiply(q[k]).subtract(p[k].multiply(q[j]));
      along = along.add(normal.multiply(new BigDecimal(d[i])));
    }
    return along.signum() == 0;
  }

  /** Interpolates the point from the corners; its rounding is a few ulp of their coordinates. */
  static void resolve(double[] data, int at, Hit hit) {
    double u = hit.u;
    double v = hit.v;
    double w = 1 - u - v;
    hit.px = u * data[at] + v * data[at + 3] + w * data[at + 6];
    hit.py = u * data[at + 1] + v * data[at + 4] + w * data[at + 7];
    hit.pz = u * data[at + 2] + v * data[at + 5] + w * data[at + 8];
    hit.setNormal(normal(data, at, 0), normal(data, at, 1), normal(data, at, 2));
    double size =
        max(data[at], data[at + 3], data[at + 6])
            + max(data[at + 1], data[at + 4], data[at + 7])
            + max(data[at + 2], data[at + 5], data[at + 8]);
    hit.offset = 4 * 0x1p-52 * size;
  }

  /** Returns whether the triangle has a normal that a double can hold; else it is never hit. */
  static boolean hasArea(double[] nine) {
    double largest = max(normal(nine, 0, 0), normal(nine, 0, 1), normal(nine, 0, 2));
    return largest >= Double.MIN_NORMAL;
  }

  /** One component of the cross product of the edges from the first corner. */
  private static double normal(double[] data, int at, int axis) {
    int i = at + (axis + 1) % 3;
    int j = at + (axis + 2) % 3;
    double ei = data[i + 3] - data[i];
    double ej = data[j + 3] - data[j];
    double fi = data[i + 6] - data[i];
    double fj = data[j + 6] - data[j];
    return ei * fj - ej * fi;
  }

  private static double max(double a, double b, double c) {
    return Math.max(Math.abs(a), Math.max(Math.abs(b), Math.abs(c)));
  }
}
