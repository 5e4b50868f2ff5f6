package glint.geometry;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/**
 * Triangles that share corners; its arrays are never changed once it is made.
 *
 * <p>Seen from both sides; where corners run counter-clockwise is the outside. A triangle without
 * area is never hit.
 */
public final class Mesh implements Surface {

  private final double[] points;
  private final int[] corners;

  /**
   * Makes a mesh that takes over the two arrays: nobody may change them any more.
   *
   * @param points x, y, z of every point
   * @param corners the numbers, from 0, of three points for every triangle
   * @throws BadValueException if a coordinate is not finite or a corner names no point
   */
  public Mesh(double[] points, int[] corners) {
    if (points.length % 3 != 0 || corners.length % 3 != 0) {
      throw new IllegalArgumentException("points and corners come in threes");
    }
    for (double v : points) {
      if (!(Math.abs(v) <= Check.LARGEST)) {
        throw new BadValueException("mesh", "must have finite coordinates up to 1e100, not " + v);
      }
    }
    for (int corner : corners) {
      if (corner < 0 || corner >= points.length / 3) {
        throw new BadValueException(
            "mesh", "has a corner " + corner + ", but only " + points.length / 3 + " points");
      }
    }
    this.points = points;
    this.corners = corners;
  }

  /** Returns the number of triangles. */
  public int triangles() {
    return corners.length / 3;
  }

  /** Returns whether it closes a body: every edge is shared by faces that run along it opposite. */
  public boolean isClosed() {
    return MeshEdges.areClosed(points, corners);
  }

  /** Returns the corners of the box around all points; none if there are none. */
  List<Vector3d> corners() {
    double[] least = new double[3];
    double[] greatest = new double[3];
    for (int i = 0; i < points.length; i++) {
      least[i % 3] = i < 3 ? points[i] : Math.min(least[i % 3], points[i]);
      greatest[i % 3] = i < 3 ? points[i] : Math.max(greatest[i % 3], points[i]);
    }
    List<Vector3d> corners = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      corners.add(
          new Vector3d(
              (i & 1) == 0 ? least[0] : greatest[0],
              (i & 2) == 0 ? least[1] : greatest[1],
              (i & 4) == 0 ? least[2] : greatest[2]));
    }
    return corners;
  }

  /** Returns one coordinate, 0 to 2, of a corner, 0 to 2, of a triangle. */
  double coordinate(int triangle, int corner, int axis) {
    return points[3 * corners[3 * triangle + corner] + axis];
  }
}
