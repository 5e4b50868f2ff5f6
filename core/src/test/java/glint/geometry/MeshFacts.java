package glint.geometry;

import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/** What tests in other packages ask of a mesh. */
public final class MeshFacts {

  private MeshFacts() {}

  /** Returns the three corners of a triangle. */
  public static List<Vector3d> corners(Mesh mesh, int triangle) {
    List<Vector3d> corners = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      corners.add(
          new Vector3d(
              mesh.coordinate(triangle, i, 0),
              mesh.coordinate(triangle, i, 1),
              mesh.coordinate(triangle, i, 2)));
    }
    return corners;
  }

  /** Returns the three normals of a triangle, or none. */
  public static List<Vector3d> normals(Mesh mesh, int triangle) {
    List<Vector3d> normals = new ArrayList<>();
    for (int i = 3 * triangle; i < 3 * triangle + 3; i++) {
      if (mesh.normals().has(i)) {
        CornerValues n = mesh.normals();
        normals.add(new Vector3d(n.of(i, 0), n.of(i, 1), n.of(i, 2)));
      }
    }
    return normals;
  }

  /** Returns the pairs (u, v) of a triangle's corners, "-" for one without. */
  public static List<String> texture(Mesh mesh, int triangle) {
    List<String> texture = new ArrayList<>();
    for (int i = 3 * triangle; i < 3 * triangle + 3; i++) {
      CornerValues t = mesh.texture();
      texture.add(t.has(i) ? t.of(i, 0) + " " + t.of(i, 1) : "-");
    }
    return texture;
  }

  /** Returns the sum of the areas of all triangles. */
  public static double area(Mesh mesh) {
    double area = 0;
    for (int i = 0; i < mesh.triangles(); i++) {
      List<Vector3d> c = corners(mesh, i);
      area += c.get(1).minus(c.get(0)).cross(c.get(2).minus(c.get(0))).length() / 2;
    }
    return area;
  }
}
