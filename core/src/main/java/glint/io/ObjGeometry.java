package glint.io;

import glint.geometry.Mesh;
import glint.math.Check;
import java.util.Arrays;

/** The points and triangles of a model while it is read: arrays that grow by half. */
final class ObjGeometry {

  private double[] points = new double[3 << 8];
  private int[] corners = new int[3 << 8];
  private int pointsUsed;
  private int cornersUsed;
  private boolean hasFar;

  void point(double x, double y, double z) {
    if (pointsUsed + 3 > points.length) {
      points = Arrays.copyOf(points, grown(points.length));
    }
    points[pointsUsed] = x;
    points[pointsUsed + 1] = y;
    points[pointsUsed + 2] = z;
    hasFar |= Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) > Check.LARGEST;
    pointsUsed += 3;
  }

  void triangle(int a, int b, int c) {
    if (cornersUsed + 3 > corners.length) {
      corners = Arrays.copyOf(corners, grown(corners.length));
    }
    corners[cornersUsed] = a;
    corners[cornersUsed + 1] = b;
    corners[cornersUsed + 2] = c;
    cornersUsed += 3;
  }

  /** Returns the next length, which is a multiple of three. */
  static int grown(int length) {
    long half = length + length / 2L;
    if (half > Integer.MAX_VALUE - 8) {
      throw new OutOfMemoryError("a model of more than 477 million points or triangles");
    }
    return (int) half / 3 * 3;
  }

  int pointCount() {
    return pointsUsed / 3;
  }

  int triangleCount() {
    return cornersUsed / 3;
  }

  double[] points() {
    return points;
  }

  /** Returns whether a point lies farther out than scenes reach. */
  boolean isFar(int point) {
    double x = Math.abs(points[3 * point]);
    double y = Math.abs(points[3 * point + 1]);
    double z = Math.abs(points[3 * point + 2]);
    return Math.max(x, Math.max(y, z)) > Check.LARGEST;
  }

  /** Returns whether any point so far lies farther out than scenes reach. */
  boolean hasFar() {
    return hasFar;
  }

  /** Returns the mesh, in arrays of its size; ends the use of this. */
  Mesh mesh() {
    double[] meshPoints = Arrays.copyOf(points, pointsUsed);
    points = null;
    int[] meshCorners = Arrays.copyOf(corners, cornersUsed);
    corners = null;
    if (hasFar) {
      // No triangle has them, or there would be a problem
      for (int i = 0; i < meshPoints.length; i++) {
        meshPoints[i] = Math.abs(meshPoints[i]) > Check.LARGEST ? 0 : meshPoints[i];
      }
    }
    return new Mesh(meshPoints, meshCorners);
  }
}
