package glint.verify;

import glint.geometry.CornerValues;
import glint.geometry.Mesh;
import glint.geometry.Primitives;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A closed mesh: corners, and three numbers of corners a triangle; immutable. */
record ClosedMesh(List<Vector3d> corners, List<int[]> faces) {

  /** Returns a sphere around the origin, cut by circles of latitude and longitude. */
  static ClosedMesh globe(double radius, int stacks, int slices) {
    List<Vector3d> corners = new ArrayList<>();
    corners.add(new Vector3d(0, 0, radius));
    for (int i = 1; i < stacks; i++) {
      double polar = StrictMath.PI * i / stacks;
      double across = radius * StrictMath.sin(polar);
      for (int k = 0; k < slices; k++) {
        double turn = 2 * StrictMath.PI * k / slices;
        double x = across * StrictMath.cos(turn);
        double y = across * StrictMath.sin(turn);
        corners.add(new Vector3d(x, y, radius * StrictMath.cos(polar)));
      }
    }
    corners.add(new Vector3d(0, 0, -radius));

    List<int[]> faces = new ArrayList<>();
    for (int i = 0; i < stacks; i++) {
      for (int k = 0; k < slices; k++) {
        int a = onGlobe(stacks, slices, i, k);
        int b = onGlobe(stacks, slices, i + 1, k);
        int c = onGlobe(stacks, slices, i + 1, k + 1);
        int d = onGlobe(stacks, slices, i, k + 1);
        if (i > 0) {
          faces.add(new int[] {a, c, d});
        }
        if (i < stacks - 1) {
          faces.add(new int[] {a, b, c});
        }
      }
    }
    return new ClosedMesh(corners, faces);
  }

  /** The corner on a circle of latitude; the first and the last circle are the poles. */
  private static int onGlobe(int stacks, int slices, int circle, int k) {
    int pole = circle == 0 ? 0 : 1 + (stacks - 1) * slices;
    return circle % stacks == 0 ? pole : 1 + (circle - 1) * slices + k % slices;
  }

  /** Returns a cube around the origin, of twelve triangles. */
  static ClosedMesh cube(double half) {
    List<Vector3d> corners = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      corners.add(new Vector3d(side(i, 1), side(i, 2), side(i, 4)).times(half));
    }
    List<int[]> faces = new ArrayList<>();
    for (int axis = 0; axis < 3; axis++) {
      int p = 1 << (axis + 1) % 3;
      int q = 1 << (axis + 2) % 3;
      for (int base : new int[] {0, 1 << axis}) {
        faces.add(new int[] {base, base + p, base + p + q});
        faces.add(new int[] {base, base + p + q, base + q});
      }
    }
    return new ClosedMesh(corners, faces);
  }

  private static double side(int corner, int bit) {
    return (corner & bit) == 0 ? -1 : 1;
  }

  /**
   * Returns a sphere of radius 1 with hills and valleys: an icosahedron, each triangle split in
   * four so many times, every corner moved along its radius by a sum of sines of at most 0.3.
   */
  static ClosedMesh hills(int splits) {
    ClosedMesh mesh = icosphere(splits);
    List<Vector3d> corners = new ArrayList<>();
    for (Vector3d v : mesh.corners) {
      Vector3d n = v.normalized();
      double wave =
          StrictMath.sin(7 * n.x() + 2 * n.y())
              + StrictMath.sin(11 * n.y() - 3 * n.z())
              + StrictMath.sin(17 * n.z() + 5 * n.x());
      corners.add(n.times(1 + 0.1 * wave));
    }
    return new ClosedMesh(corners, mesh.faces);
  }

  /** Returns a sphere of radius 1: an icosahedron, each triangle split in four so many times. */
  static ClosedMesh icosphere(int splits) {
    ClosedMesh mesh = icosahedron();
    for (int i = 0; i < splits; i++) {
      mesh = mesh.split();
    }
    return mesh;
  }

  private static ClosedMesh icosahedron() {
    double g = (1 + Math.sqrt(5)) / 2;
    List<Vector3d> corners = new ArrayList<>();
    for (double s : new double[] {-1, 1}) {
      for (double t : new double[] {-g, g}) {
        corners.add(new Vector3d(0, s, t).normalized());
        corners.add(new Vector3d(s, t, 0).normalized());
        corners.add(new Vector3d(t, 0, s).normalized());
      }
    }
    // Three corners at mutual distance 1.05 are a face; the next distance is 1.7.
    List<int[]> faces = new ArrayList<>();
    for (int a = 0; a < 12; a++) {
      for (int b = a + 1; b < 12; b++) {
        for (int c = b + 1; c < 12; c++) {
          if (near(corners, a, b) && near(corners, b, c) && near(corners, a, c)) {
            Vector3d n = corners.get(a).cross(corners.get(b));
            faces.add(n.dot(corners.get(c)) > 0 ? new int[] {a, b, c} : new int[] {a, c, b});
          }
        }
      }
    }
    return new ClosedMesh(corners, faces);
  }

  private static boolean near(List<Vector3d> corners, int a, int b) {
    return corners.get(a).minus(corners.get(b)).length() < 1.1;
  }

  private ClosedMesh split() {
    List<Vector3d> all = new ArrayList<>(corners);
    Map<Long, Integer> middles = new HashMap<>();
    List<int[]> quarters = new ArrayList<>();
    for (int[] f : faces) {
      int p = middle(f[0], f[1], all, middles);
      int q = middle(f[1], f[2], all, middles);
      int r = middle(f[2], f[0], all, middles);
      quarters.add(new int[] {f[0], p, r});
      quarters.add(new int[] {p, f[1], q});
      quarters.add(new int[] {r, q, f[2]});
      quarters.add(new int[] {p, q, r});
    }
    return new ClosedMesh(all, quarters);
  }

  private static int middle(int a, int b, List<Vector3d> all, Map<Long, Integer> middles) {
    long edge = (long) Math.min(a, b) << 32 | Math.max(a, b);
    return middles.computeIfAbsent(
        edge,
        e -> {
          all.add(all.get(a).plus(all.get(b)).normalized());
          return all.size() - 1;
        });
  }

  /** Returns this mesh scaled, then moved; corners round, but stay shared. */
  ClosedMesh placed(double scale, Vector3d offset) {
    List<Vector3d> moved = new ArrayList<>();
    for (Vector3d v : corners) {
      moved.add(v.times(scale).plus(offset));
    }
    return new ClosedMesh(moved, faces);
  }

  /** Returns this mesh with a hollow of the shape of another one, which lies inside. */
  ClosedMesh around(ClosedMesh hollow) {
    List<Vector3d> all = new ArrayList<>(corners);
    all.addAll(hollow.corners);
    List<int[]> both = new ArrayList<>(faces);
    int n = corners.size();
    hollow.faces.forEach(f -> both.add(new int[] {n + f[0], n + f[2], n + f[1]}));
    return new ClosedMesh(all, both);
  }

  Vector3d corner(int face, int i) {
    return corners.get(faces.get(face)[i % 3]);
  }

  Primitives primitives() {
    return Shoot.primitives(List.of(surface()));
  }

  /** Returns a mesh that looks round: the normals at its corners lead away from the origin. */
  Mesh round() {
    Mesh flat = surface();
    double[] normals = new double[3 * corners.size()];
    for (int i = 0; i < corners.size(); i++) {
      normals[3 * i] = corners.get(i).x();
      normals[3 * i + 1] = corners.get(i).y();
      normals[3 * i + 2] = corners.get(i).z();
    }
    int[] three = faces.stream().flatMapToInt(Arrays::stream).toArray();
    return flat.withNormals(new CornerValues(3, normals, three), new int[faces.size()]);
  }

  Mesh surface() {
    double[] points = new double[3 * corners.size()];
    for (int i = 0; i < corners.size(); i++) {
      points[3 * i] = corners.get(i).x();
      points[3 * i + 1] = corners.get(i).y();
      points[3 * i + 2] = corners.get(i).z();
    }
    int[] three = faces.stream().flatMapToInt(Arrays::stream).toArray();
    return new Mesh(points, three);
  }
}
