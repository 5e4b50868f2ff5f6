package glint.geometry;

import java.util.Arrays;

/** The corners of triangles that meet at one place, and which of them share a normal; scratch. */
final class Fan {

  private final double[] points;
  private final int[] corners;

  /** For every point the first one at its place. */
  private final int[] places;

  private int size;
  private int[] corner = new int[16];

  /** The unit normal of each corner's triangle, zero if it has no area. */
  private double[] normal = new double[48];

  /** The angle between the triangle's two edges here, in radians. */
  private double[] angle = new double[16];

  /** A corner of the same class with a lower or the same number: the least one is the class. */
  private int[] parent = new int[16];

  private long[] keys = new long[32];

  Fan(double[] points, int[] corners, int[] places) {
    this.points = points;
    this.corners = corners;
    this.places = places;
  }

  void clear() {
    size = 0;
  }

  int size() {
    return size;
  }

  /** Returns the corner, three times the triangle's number and 0 to 2, that was added i-th. */
  int corner(int i) {
    return corner[i];
  }

  /** Adds a corner, which shares with none. */
  void add(int newCorner) {
    if (size == corner.length) {
      corner = Arrays.copyOf(corner, 2 * size);
      normal = Arrays.copyOf(normal, 6 * size);
      angle = Arrays.copyOf(angle, 2 * size);
      parent = Arrays.copyOf(parent, 2 * size);
      keys = new long[4 * size];
    }
    corner[size] = newCorner;
    parent[size] = size;
    angle[size] = faceNormal(points, corners, newCorner, normal, 3 * size);
    size++;
  }

  /**
   * Writes the unit normal of a corner's triangle, zero if it has no area, and returns the angle
   * between its edges there.
   */
  static double faceNormal(double[] points, int[] corners, int corner, double[] out, int at) {
    int first = corner / 3 * 3;
    int p = 3 * corners[corner];
    int q = 3 * corners[first + (corner + 1) % 3];
    int r = 3 * corners[first + (corner + 2) % 3];
    double ex = points[q] - points[p];
    double ey = points[q + 1] - points[p + 1];
    double ez = points[q + 2] - points[p + 2];
    double fx = points[r] - points[p];
    double fy = points[r + 1] - points[p + 1];
    double fz = points[r + 2] - points[p + 2];
    // Divide by powers of two first, so that no product overflows or vanishes.
    double e = Ray.power(-Ray.exponent(ex, ey, ez));
    double f = Ray.power(-Ray.exponent(fx, fy, fz));
    double x = ey * e * (fz * f) - ez * e * (fy * f);
    double y = ez * e * (fx * f) - ex * e * (fz * f);
    double z = ex * e * (fy * f) - ey * e * (fx * f);
    double length = Math.sqrt(x * x + y * y + z * z);
    out[at] = length > 0 ? x / length : 0;
    out[at + 1] = length > 0 ? y / length : 0;
    out[at + 2] = length > 0 ? z / length : 0;
    double dot = ex * e * (fx * f) + ey * e * (fy * f) + ez * e * (fz * f);
    return length > 0 ? StrictMath.atan2(length, dot) : 0;
  }

  /** Lets the corners of triangles of the same smoothing group share. */
  void shareByGroup(int[] groups) {
    for (int i = 0; i < size; i++) {
      keys[i] = (long) groups[corner[i] / 3] << 32 | i;
    }
    share(size, -2);
  }

  /** Lets corners share whose triangles have an edge in common and normals of more than a cos. */
  void shareByAngle(double cos) {
    for (int i = 0; i < size; i++) {
      int first = corner[i] / 3 * 3;
      keys[2 * i] = (long) places[corners[first + (corner[i] + 1) % 3]] << 32 | i;
      keys[2 * i + 1] = (long) places[corners[first + (corner[i] + 2) % 3]] << 32 | i;
    }
    share(2 * size, cos);
  }

  /** Lets neighbours share among those of equal keys. */
  private void share(int count, double cos) {
    Arrays.sort(keys, 0, count);
    for (int k = 1; k < count; k++) {
      int i = (int) keys[k - 1];
      int j = (int) keys[k];
      if (keys[k - 1] >> 32 == keys[k] >> 32 && dot(i, j) > cos) {
        int a = shared(i);
        int b = shared(j);
        parent[Math.max(a, b)] = Math.min(a, b);
      }
    }
  }

  private double dot(int i, int j) {
    return normal[3 * i] * normal[3 * j]
        + normal[3 * i + 1] * normal[3 * j + 1]
        + normal[3 * i + 2] * normal[3 * j + 2];
  }

  /** Returns the class of the corner that was added i-th: the first that shares with it. */
  int shared(int i) {
    int root = i;
    while (parent[root] != root) {
      parent[root] = parent[parent[root]];
      root = parent[root];
    }
    return root;
  }

  /**
   * Sums up the normals of triangles times their angles here.
   *
   * @param sums for every class three numbers, at its place
   * @param counts how many corners each class has
   */
  void sumUp(double[] sums, int[] counts) {
    Arrays.fill(sums, 0, 3 * size, 0);
    Arrays.fill(counts, 0, size, 0);
    for (int i = 0; i < size; i++) {
      int shared = shared(i);
      counts[shared]++;
      for (int axis = 0; axis < 3; axis++) {
        sums[3 * shared + axis] += angle[i] * normal[3 * i + axis];
      }
    }
  }
}
