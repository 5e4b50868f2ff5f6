package glint.geometry;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/**
 * Triangles that share corners; its arrays are never changed once it is made.
 *
 * <p>Seen from both sides; where corners run counter-clockwise is the outside. A triangle without
 * area is never hit. One with normals at its corners stands for a curved surface.
 */
public final class Mesh implements Surface {

  private final double[] points;
  private final int[] corners;

  /** The least and the greatest coordinates of all points; the origin if there are none. */
  private final double[] box;

  /** Unit normals, at three corners of a triangle or at none. */
  private final CornerValues normals;

  private final MeshParts parts;
  private final CornerValues texture;

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
    box = new double[6];
    for (int i = 0; i < points.length; i++) {
      double v = points[i];
      if (!(Math.abs(v) <= Check.LARGEST)) {
        throw new BadValueException("mesh", "must have finite coordinates up to 1e100, not " + v);
      }
      int axis = i % 3;
      box[axis] = i < 3 ? v : Math.min(box[axis], v);
      box[3 + axis] = i < 3 ? v : Math.max(box[3 + axis], v);
    }
    for (int corner : corners) {
      if (corner < 0 || corner >= points.length / 3) {
        throw new BadValueException(
            "mesh", "has a corner " + corner + ", but only " + points.length / 3 + " points");
      }
    }
    this.points = points;
    this.corners = corners;
    normals = CornerValues.NONE;
    texture = CornerValues.NONE;
    parts = MeshParts.ONE;
  }

  private Mesh(Mesh other, CornerValues normals, CornerValues texture, MeshParts parts) {
    points = other.points;
    corners = other.corners;
    box = other.box;
    this.normals = normals;
    this.texture = texture;
    this.parts = parts;
  }

  /**
   * Returns this mesh in parts, which may be of different materials.
   *
   * @param starts the first triangle of each run of triangles of one part: 0, and then higher ones
   * @param partOf the part of each run; parts have numbers from 0
   */
  public Mesh inParts(int[] starts, int[] partOf) {
    return new Mesh(this, normals, texture, new MeshParts(starts.clone(), partOf.clone()));
  }

  /** Returns the number of parts, at least 1. */
  public int parts() {
    return parts.count();
  }

  /** Returns the part, from 0, of a triangle. */
  public int part(int triangle) {
    return parts.of(triangle);
  }

  /**
   * Returns this mesh with normals, by which light sees it as curved.
   *
   * <p>A corner without one shares that of its smoothing group, if its triangle is in one: the sum
   * of the triangles' normals there, weighted by their angles. A triangle that then has none is
   * flat.
   *
   * @param given normals of any length; one of length zero is none
   * @param groups the smoothing group of each triangle, 0 for none; empty if none has one
   */
  public Mesh withNormals(CornerValues given, int[] groups) {
    requireFit(given);
    if (groups.length != triangles() && groups.length > 0) {
      throw new IllegalArgumentException("every triangle needs a smoothing group, or 0");
    }
    if (given.isEmpty() && groups.length == 0) {
      return new Mesh(this, CornerValues.NONE, texture, parts);
    }
    return new Mesh(this, new NormalFinder(points, corners, given).byGroup(groups), texture, parts);
  }

  /** Returns this mesh with pairs (u, v) at its corners, by which a picture is laid on it. */
  public Mesh withTexture(CornerValues pairs) {
    requireFit(pairs);
    return new Mesh(this, normals, pairs, parts);
  }

  /**
   * Returns this mesh with normals where it has none: triangles that have an edge in common and
   * meet there at less than an angle, 0 to 180 degrees, share them at its ends.
   */
  public Mesh smoothed(double degrees) {
    return new Mesh(
        this, new NormalFinder(points, corners, normals).byAngle(degrees), texture, parts);
  }

  private void requireFit(CornerValues values) {
    if (!values.isEmpty() && values.corners() != corners.length) {
      throw new IllegalArgumentException("every corner needs a value, or -1");
    }
  }

  /** Returns the unit normals of corners: of a triangle's three, or of none. */
  CornerValues normals() {
    return normals;
  }

  /** Returns the pairs (u, v) of corners. */
  CornerValues texture() {
    return texture;
  }

  /** Returns whether any triangle has normals at its corners. */
  public boolean isSmooth() {
    return !normals.isEmpty();
  }

  /** Sets the shading normal, and where shadow rays leave, of a faced hit on a triangle. */
  public void shade(int triangle, Transform toWorld, Hit hit) {
    if (normals.has(3 * triangle)) {
      SmoothTriangle.shade(points, corners, normals, triangle, toWorld, hit);
    }
  }

  /** Returns whether any corner has a pair (u, v). */
  public boolean hasTexturePoints() {
    return !texture.isEmpty();
  }

  /** Sets the pair (u, v) of a hit on a triangle; corners without one have (0, 0). */
  public void findTexture(int triangle, Hit hit) {
    double w = 1 - hit.u - hit.v;
    hit.textureU =
        hit.u * pair(triangle, 0, 0) + hit.v * pair(triangle, 1, 0) + w * pair(triangle, 2, 0);
    hit.textureV =
        hit.u * pair(triangle, 0, 1) + hit.v * pair(triangle, 1, 1) + w * pair(triangle, 2, 1);
  }

  private double pair(int triangle, int corner, int i) {
    int at = 3 * triangle + corner;
    return texture.has(at) ? texture.of(at, i) : 0;
  }

  /** Returns the number of triangles. */
  public int triangles() {
    return corners.length / 3;
  }

  /** Returns whether it closes a body: every edge is shared by faces that run along it opposite. */
  public boolean isClosed() {
    return MeshEdges.areClosed(points, corners);
  }

  /** Returns the corners of the box around all points. */
  public List<Vector3d> corners() {
    List<Vector3d> corners = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      corners.add(new Vector3d(box[3 * (i & 1)], box[1 + 3 * (i >> 1 & 1)], box[2 + 3 * (i >> 2)]));
    }
    return corners;
  }

  /** Returns the largest absolute coordinate. */
  public double size() {
    double size = 0;
    for (double v : box) {
      size = Math.max(size, Math.abs(v));
    }
    return size;
  }

  /** Writes the nine coordinates of a triangle's corners. */
  public void corners(int triangle, double[] out) {
    for (int i = 0; i < 9; i++) {
      out[i] = coordinate(triangle, i / 3, i % 3);
    }
  }

  /** Returns one coordinate, 0 to 2, of a corner, 0 to 2, of a triangle. */
  public double coordinate(int triangle, int corner, int axis) {
    return points[3 * corners[3 * triangle + corner] + axis];
  }
}
