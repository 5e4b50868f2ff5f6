package glint.io;

import glint.io.EarClipper.Outcome;

/**
 * Divides polygons in space into triangles: convex ones by a fan, others by clipping ears.
 *
 * <p>A polygon is looked at along its mean normal (M. Newell), scaled so that one that is square to
 * an axis keeps its coordinates, and what lies on a line there stays on it exactly.
 */
final class Triangulator {

  private final FlatPolygon flat = new FlatPolygon();
  private final EarClipper clipper = new EarClipper(flat);
  private final double[] normal = new double[3];
  private int[] triangles = {};

  /**
   * Divides a polygon of at least four corners.
   *
   * @param corners x, y, z of each, of which the first {@code n} count
   */
  Outcome divide(double[] corners, int n) {
    if (3L * n > triangles.length) {
      triangles = new int[Math.max(3 * n, 2 * triangles.length)];
    }
    measureNormal(corners, n);
    boolean flattened = flatten(corners, n);
    if (flattened && !flat.isStrictlyConvex()) {
      return clipper.clip(triangles);
    }
    for (int i = 2; i < n; i++) {
      triangles[3 * i - 6] = 0;
      triangles[3 * i - 5] = i - 1;
      triangles[3 * i - 4] = i;
    }
    return Outcome.DIVIDED;
  }

  /** Returns one corner of the n - 2 triangles as its place, from 0, in the polygon. */
  int corner(int i) {
    return triangles[i];
  }

  /** Sums up the cross products of successive corners, seen from the first. */
  private void measureNormal(double[] corners, int n) {
    double nx = 0;
    double ny = 0;
    double nz = 0;
    double ax = 0;
    double ay = 0;
    double az = 0;
    for (int at = 3; at < 3 * n; at += 3) {
      double bx = corners[at] - corners[0];
      double by = corners[at + 1] - corners[1];
      double bz = corners[at + 2] - corners[2];
      nx += ay * bz - az * by;
      ny += az * bx - ax * bz;
      nz += ax * by - ay * bx;
      ax = bx;
      ay = by;
      az = bz;
    }
    normal[0] = nx;
    normal[1] = ny;
    normal[2] = nz;
  }

  /** Slides the corners along the normal into an axis plane; returns whether there is a normal. */
  private boolean flatten(double[] corners, int n) {
    int axis = 0;
    for (int i = 1; i < 3; i++) {
      axis = Math.abs(normal[i]) > Math.abs(normal[axis]) ? i : axis;
    }
    boolean seenFromBelow = normal[axis] < 0;
    int u = (axis + (seenFromBelow ? 2 : 1)) % 3;
    int v = (axis + (seenFromBelow ? 1 : 2)) % 3;
    double du = normal[u] / normal[axis];
    double dv = normal[v] / normal[axis];
    flat.begin(n);
    for (int i = 0; i < n; i++) {
      double height = corners[3 * i + axis] - corners[axis];
      flat.set(i, corners[3 * i + u] - height * du, corners[3 * i + v] - height * dv);
    }
    return normal[axis] != 0;
  }
}
