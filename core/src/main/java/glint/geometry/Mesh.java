package glint.geometry;

import glint.math.BadValueException;
import glint.math.Check;

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

  /** Returns one coordinate, 0 to 2, of a corner, 0 to 2, of a triangle. */
  double coordinate(int triangle, int corner, int axis) {
    return points[3 * corners[3 * triangle + corner] + axis];
  }
}
