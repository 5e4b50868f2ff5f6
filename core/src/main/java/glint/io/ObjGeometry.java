package glint.io;

import glint.geometry.Mesh;
import glint.math.Check;

/** The points and triangles of a model while it is read. */
final class ObjGeometry {

  private final Doubles points = new Doubles();
  private final Ints corners = new Ints();

  final ObjCorners normals = new ObjCorners(3);
  final ObjCorners textures = new ObjCorners(2);

  /** The smoothing group of each triangle, as far as there are any. */
  private final Ints groups = new Ints();

  private boolean hasFar;

  void point(double x, double y, double z) {
    points.add(x);
    points.add(y);
    points.add(z);
    hasFar |= Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) > Check.LARGEST;
  }

  /**
   * Adds a triangle.
   *
   * @param group its smoothing group, or 0
   */
  void triangle(int a, int b, int c, int group) {
    if (group != 0) {
      groups.fill(triangleCount(), 0);
      groups.add(group);
    }
    corners.add(a);
    corners.add(b);
    corners.add(c);
  }

  int pointCount() {
    return points.size() / 3;
  }

  int triangleCount() {
    return corners.size() / 3;
  }

  /** Returns one coordinate, 0 to 2, of a point. */
  double coordinate(int point, int axis) {
    return points.get(3 * point + axis);
  }

  /** Returns whether a point lies farther out than scenes reach. */
  boolean isFar(int point) {
    boolean far = false;
    for (int axis = 0; axis < 3; axis++) {
      far |= Math.abs(coordinate(point, axis)) > Check.LARGEST;
    }
    return far;
  }

  /** Returns whether any point so far lies farther out than scenes reach. */
  boolean hasFar() {
    return hasFar;
  }

  /** Returns the mesh; ends the use of this. */
  Mesh mesh() {
    double[] meshPoints = points.toArray();
    if (hasFar) {
      // No triangle has them, or there would be a problem
      for (int i = 0; i < meshPoints.length; i++) {
        meshPoints[i] = Math.abs(meshPoints[i]) > Check.LARGEST ? 0 : meshPoints[i];
      }
    }
    if (groups.size() > 0) {
      groups.fill(triangleCount(), 0);
    }
    int count = corners.size();
    return new Mesh(meshPoints, corners.toArray())
        .withTexture(textures.values(count))
        .withNormals(normals.values(count), groups.toArray());
  }
}
