package glint.geometry;

import glint.math.Rounding;
import glint.math.Transform;

/**
 * The ray and the hit of a surface that cannot be carried into the world, such as an ellipsoid.
 *
 * <p>The ray moves into object space instead; t is the same in both. Data: the twelve numbers of
 * the world-to-object matrix, then the twelve of object-to-world; the surface's own follow.
 */
final class TransformedKernel {

  /** How many doubles the two matrices take. */
  static final int SIZE = 24;

  private TransformedKernel() {}

  static double[] pack(Transform objectToWorld, double[] surface) {
    double[] data = new double[SIZE + surface.length];
    System.arraycopy(objectToWorld.inverted().rows(), 0, data, 0, 12);
    System.arraycopy(objectToWorld.rows(), 0, data, 12, 12);
    System.arraycopy(surface, 0, data, SIZE, surface.length);
    return data;
  }

  /**
   * Sets {@code local} to the ray as object space sees it, its direction divided by a power of two
   * to have a length of 1 to 4.
   */
  static void toObject(double[] data, int at, Ray world, Ray local) {
    double dx = row(data, at, world.dx, world.dy, world.dz);
    double dy = row(data, at + 4, world.dx, world.dy, world.dz);
    double dz = row(data, at + 8, world.dx, world.dy, world.dz);
    int exponent = Ray.exponent(dx, dy, dz);
    local.unit = Ray.power(-exponent);
    local.set(
        row(data, at, world.ox, world.oy, world.oz) + data[at + 3],
        row(data, at + 4, world.ox, world.oy, world.oz) + data[at + 7],
        row(data, at + 8, world.ox, world.oy, world.oz) + data[at + 11],
        dx * local.unit,
        dy * local.unit,
        dz * local.unit);
    local.tMin = world.tMin * Ray.power(exponent);
    local.least = world.tMin;
    local.after = world.after;
  }

  /** Carries a box into the world: the box around its eight moved corners (Arvo 1990). */
  static void boundsToWorld(double[] data, int at, double[] box) {
    double[] object = box.clone();
    for (int row = 0; row < 3; row++) {
      int m = at + 12 + 4 * row;
      double least = data[m + 3];
      double greatest = data[m + 3];
      for (int axis = 0; axis < 3; axis++) {
        double a = data[m + axis] * object[axis];
        double b = data[m + axis] * object[3 + axis];
        least += Math.min(a, b);
        greatest += Math.max(a, b);
      }
      box[row] = least;
      box[3 + row] = greatest;
    }
  }

  /**
   * Carries a hit resolved in object space into the world.
   *
   * <p>A world step e along the unit world normal n = M⁻ᵀn'/|M⁻ᵀn'| moves the object point by
   * e|M⁻ᵀn'| off the surface. It must cover the object offset, the rounding of the point on its way
   * here (γ(4)(|M||p'| + |T|), and γ(1) for storing the moved origin) and that of the origin on its
   * way back (γ(4)(|M⁻¹||p| + |T⁻¹|), seen along n').
   */
  static void toWorld(double[] data, int at, Hit hit) {
    double gamma = Rounding.gamma(5);
    double x = hit.px;
    double y = hit.py;
    double z = hit.pz;
    double objectNx = hit.nx;
    double objectNy = hit.ny;
    double objectNz = hit.nz;
    int m = at + 12;
    hit.px = row(data, m, x, y, z) + data[m + 3];
    hit.py = row(data, m + 4, x, y, z) + data[m + 7];
    hit.pz = row(data, m + 8, x, y, z) + data[m + 11];
    double nx = data[at] * objectNx + data[at + 4] * objectNy + data[at + 8] * objectNz;
    double ny = data[at + 1] * objectNx + data[at + 5] * objectNy + data[at + 9] * objectNz;
    double nz = data[at + 2] * objectNx + data[at + 6] * objectNy + data[at + 10] * objectNz;
    hit.setNormal(nx, ny, nz);
    double stretch = nx * hit.nx + ny * hit.ny + nz * hit.nz;
    double there =
        gamma
            * (Math.abs(hit.nx) * absRow(data, m, x, y, z)
                + Math.abs(hit.ny) * absRow(data, m + 4, x, y, z)
                + Math.abs(hit.nz) * absRow(data, m + 8, x, y, z));
    double back =
        gamma
            * (Math.abs(objectNx) * absRow(data, at, hit.px, hit.py, hit.pz)
                + Math.abs(objectNy) * absRow(data, at + 4, hit.px, hit.py, hit.pz)
                + Math.abs(objectNz) * absRow(data, at + 8, hit.px, hit.py, hit.pz));
    // One stored matrix is not the other's inverse exactly: see by how much the way back misses.
    double missed =
        objectNx * (row(data, at, hit.px, hit.py, hit.pz) + data[at + 3] - x)
            + objectNy * (row(data, at + 4, hit.px, hit.py, hit.pz) + data[at + 7] - y)
            + objectNz * (row(data, at + 8, hit.px, hit.py, hit.pz) + data[at + 11] - z);
    hit.offset = 2 * ((hit.offset + back + Math.abs(missed)) / stretch + there);
  }

  private static double row(double[] data, int at, double x, double y, double z) {
    return data[at] * x + data[at + 1] * y + data[at + 2] * z;
  }

  private static double absRow(double[] data, int at, double x, double y, double z) {
    return Math.abs(data[at] * x)
        + Math.abs(data[at + 1] * y)
        + Math.abs(data[at + 2] * z)
        + Math.abs(data[at + 3]);
  }
}
