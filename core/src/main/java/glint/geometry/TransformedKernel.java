package glint.geometry;

import glint.math.Rounding;
import glint.math.Transform;

/**
 * The ray and the hit of a surface that cannot be carried into the world, such as an ellipsoid.
 *
 * <p>The ray moves into object space instead; t is the same in both. Data: the 21 numbers of the
 * transform p = M p' + T, namely the rows of M⁻¹, those of M, and T; the surface's own follow.
 */
final class TransformedKernel {

  /** How many doubles the transform takes. */
  static final int SIZE = Transform.NUMBERS;

  private static final int FORWARD = 9;
  private static final int ORIGIN = 18;

  private TransformedKernel() {}

  static double[] pack(Transform objectToWorld, double[] surface) {
    double[] data = new double[SIZE + surface.length];
    objectToWorld.copyTo(data);
    System.arraycopy(surface, 0, data, SIZE, surface.length);
    return data;
  }

  /**
   * Sets {@code local} to the ray as object space sees it, its direction divided by a power of two
   * to have a length of 1 to 4.
   */
  static void toObject(double[] data, int at, Ray world, Ray local) {
    double dx = row(data, at, world.dx, world.dy, world.dz);
    double dy = row(data, at + 3, world.dx, world.dy, world.dz);
    double dz = row(data, at + 6, world.dx, world.dy, world.dz);
    int exponent = Ray.exponent(dx, dy, dz);
    local.unit = Ray.power(-exponent);
    double x = world.ox - data[at + ORIGIN];
    double y = world.oy - data[at + ORIGIN + 1];
    double z = world.oz - data[at + ORIGIN + 2];
    local.set(
        row(data, at, x, y, z),
        row(data, at + 3, x, y, z),
        row(data, at + 6, x, y, z),
        dx * local.unit,
        dy * local.unit,
        dz * local.unit);
    local.tMin = world.tMin;
    local.after = world.after;
  }

  /**
   * Carries a box into the world: the box around its eight moved corners (Arvo 1990).
   *
   * <p>It is wider by what a hit may lie off it because either the origin of object space or the
   * box in it lies far away: bands of 161u times that (see Intersector), times ‖M‖‖M⁻¹‖.
   */
  static void boundsToWorld(double[] data, int at, double[] box) {
    double[] object = box.clone();
    double far = 0;
    for (int axis = 0; axis < 3; axis++) {
      far = Math.max(far, Math.abs(data[at + ORIGIN + axis]));
      for (int row = 0; row < 3; row++) {
        double m = Math.abs(data[at + FORWARD + 3 * row + axis]);
        far = Math.max(far, m * Math.max(Math.abs(object[axis]), Math.abs(object[3 + axis])));
      }
    }
    double band = 3 * 161 * Rounding.U * far * flattening(data, at);
    for (int row = 0; row < 3; row++) {
      int m = at + FORWARD + 3 * row;
      double least = data[at + ORIGIN + row];
      double greatest = least;
      for (int axis = 0; axis < 3; axis++) {
        double a = data[m + axis] * object[axis];
        double b = data[m + axis] * object[3 + axis];
        least += Math.min(a, b);
        greatest += Math.max(a, b);
      }
      box[row] = least - band;
      box[3 + row] = greatest + band;
    }
  }

  /** Returns ‖M‖‖M⁻¹‖ in Frobenius norms: the most that a round trip magnifies rounding. */
  static double flattening(double[] data, int at) {
    return norm(data, at) * norm(data, at + FORWARD);
  }

  private static double norm(double[] data, int at) {
    double largest = 0;
    for (int i = at; i < at + FORWARD; i++) {
      largest = Math.max(largest, Math.abs(data[i]));
    }
    double sum = 0;
    for (int i = at; i < at + FORWARD; i++) {
      sum += (data[i] / largest) * (data[i] / largest);
    }
    return largest * Math.sqrt(sum);
  }

  /**
   * Carries a hit resolved in object space into the world.
   *
   * <p>A world step e along the unit world normal n = M⁻ᵀn'/|M⁻ᵀn'| moves the object point by
   * e|M⁻ᵀn'| off the surface. It must cover the object offset, the rounding of the point on its way
   * here (γ(4)(|M||p'| + |T|), and γ(1) for storing the moved origin) and that of the origin on its
   * way back (γ(4)|M⁻¹||p - T|, seen along n').
   */
  static void toWorld(double[] data, int at, Hit hit) {
    double gamma = Rounding.gamma(5);
    double x = hit.px;
    double y = hit.py;
    double z = hit.pz;
    double objectNx = hit.nx;
    double objectNy = hit.ny;
    double objectNz = hit.nz;
    int m = at + FORWARD;
    double originX = data[at + ORIGIN];
    double originY = data[at + ORIGIN + 1];
    double originZ = data[at + ORIGIN + 2];
    hit.px = row(data, m, x, y, z) + originX;
    hit.py = row(data, m + 3, x, y, z) + originY;
    hit.pz = row(data, m + 6, x, y, z) + originZ;
    double nx = data[at] * objectNx + data[at + 3] * objectNy + data[at + 6] * objectNz;
    double ny = data[at + 1] * objectNx + data[at + 4] * objectNy + data[at + 7] * objectNz;
    double nz = data[at + 2] * objectNx + data[at + 5] * objectNy + data[at + 8] * objectNz;
    hit.setNormal(nx, ny, nz);
    double stretch = nx * hit.nx + ny * hit.ny + nz * hit.nz;
    double there =
        gamma
            * (Math.abs(hit.nx) * (absRow(data, m, x, y, z) + Math.abs(originX))
                + Math.abs(hit.ny) * (absRow(data, m + 3, x, y, z) + Math.abs(originY))
                + Math.abs(hit.nz) * (absRow(data, m + 6, x, y, z) + Math.abs(originZ)));
    double wayX = hit.px - originX;
    double wayY = hit.py - originY;
    double wayZ = hit.pz - originZ;
    double back =
        gamma
            * (Math.abs(objectNx) * absRow(data, at, wayX, wayY, wayZ)
                + Math.abs(objectNy) * absRow(data, at + 3, wayX, wayY, wayZ)
                + Math.abs(objectNz) * absRow(data, at + 6, wayX, wayY, wayZ));
    // One stored matrix is not the other's inverse exactly: see by how much the way back misses.
    double missed =
        objectNx * (row(data, at, wayX, wayY, wayZ) - x)
            + objectNy * (row(data, at + 3, wayX, wayY, wayZ) - y)
            + objectNz * (row(data, at + 6, wayX, wayY, wayZ) - z);
    hit.offset = 2 * ((hit.offset + back + Math.abs(missed)) / stretch + there);
  }

  /**
   * Carries a shading normal and a lift, both on the side of a hit that was faced, into the world.
   */
  static void shadingToWorld(
      double[] m, double nx, double ny, double nz, double x, double y, double z, Hit hit) {
    hit.setShading(
        m[0] * nx + m[3] * ny + m[6] * nz,
        m[1] * nx + m[4] * ny + m[7] * nz,
        m[2] * nx + m[5] * ny + m[8] * nz);
    double liftX = row(m, FORWARD, x, y, z);
    double liftY = row(m, FORWARD + 3, x, y, z);
    double liftZ = row(m, FORWARD + 6, x, y, z);
    boolean rises = liftX * hit.nx + liftY * hit.ny + liftZ * hit.nz > 0;
    hit.liftX = rises ? liftX : 0;
    hit.liftY = rises ? liftY : 0;
    hit.liftZ = rises ? liftZ : 0;
  }

  private static double row(double[] data, int at, double x, double y, double z) {
    return data[at] * x + data[at + 1] * y + data[at + 2] * z;
  }

  private static double absRow(double[] data, int at, double x, double y, double z) {
    return Math.abs(data[at] * x) + Math.abs(data[at + 1] * y) + Math.abs(data[at + 2] * z);
  }
}
