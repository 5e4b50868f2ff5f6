package glint.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.BadValueException;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Normals at the corners of meshes: given, found, and seen at a hit. */
class SmoothMeshTest {

  /**
   * Two squares that meet at a right angle along the y axis, in four triangles; no corner twice.
   */
  private static final double[] ROOF = {0, 0, 0, 0, 1, 0, 1, 0, -1, 1, 1, -1, -1, 0, -1, -1, 1, -1};

  private static final int[] ROOF_CORNERS = {0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4};

  private static Mesh roof() {
    return new Mesh(ROOF.clone(), ROOF_CORNERS.clone());
  }

  private static CornerValues normals(double[] values, int... indices) {
    return new CornerValues(3, values, indices);
  }

  /** The shading normal where a ray straight down meets a mesh in its place. */
  private static Vector3d shading(Mesh mesh, Transform toWorld, double x, double y) {
    Hit hit = hit(mesh, toWorld, new Vector3d(x, y, 9), new Vector3d(0, 0, -1));
    return new Vector3d(hit.sx, hit.sy, hit.sz);
  }

  private static Hit hit(Mesh mesh, Transform toWorld, Vector3d o, Vector3d d) {
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(new Sphere(new Vector3d(1e9, 0, 0), 1), Transform.IDENTITY, 0);
    builder.add(mesh, toWorld, 1);
    Primitives primitives = builder.build();
    Ray ray = new Ray();
    ray.set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    Hit hit = new Hit();
    hit.begin(Double.POSITIVE_INFINITY);
    for (int slot = 0; slot < primitives.count(); slot++) {
      primitives.intersect(slot, ray, hit, new Ray());
    }
    assertTrue(hit.found());
    primitives.resolve(ray, hit, new Ray());
    hit.face(ray);
    mesh.shade(primitives.triangle(hit), toWorld, hit);
    return hit;
  }

  private static void assertNear(Vector3d expected, Vector3d actual) {
    assertEquals(0, expected.normalized().minus(actual).length(), 1e-15, () -> "but is " + actual);
  }

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  @Test
  void facesBelowTheAngleShareTheirEdgesNormals() {
    assertFalse(roof().isSmooth());
    Mesh sharp = roof().smoothed(90);
    assertNear(v(1, 0, 1), shading(sharp, Transform.IDENTITY, 0.01, 0.5));
    Mesh smooth = roof().smoothed(90.0001);
    assertTrue(smooth.isSmooth());
    assertNear(v(0, 0, 1), shading(smooth, Transform.IDENTITY, 0, 0.5));
    assertNear(v(1, 0, 1), shading(smooth, Transform.IDENTITY, 1, 0.5));
    assertNear(v(-1, 0, 1), shading(smooth, Transform.IDENTITY, -1, 0.5));
    // Halfway down, halfway between the two normals' ends.
    double half = Math.sqrt(0.5);
    assertNear(v(half, 0, 1 + half), shading(smooth, Transform.IDENTITY, 0.5, 0.25));
  }

  /** Triangles of areas 6 and 7.5 meet with angles of 90 degrees each, at another corner not. */
  @Test
  void anglesAreTheWeights() {
    double[] points = {0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 5};
    int[] corners = {0, 1, 2, 0, 2, 3};
    Mesh two = new Mesh(points, corners).smoothed(120);
    Hit hit = hit(two, Transform.IDENTITY, v(-1, -1, -1), v(1, 1, 1));
    assertNear(v(-1, 0, -1), v(hit.sx, hit.sy, hit.sz));
    hit = hit(two, Transform.IDENTITY, v(-1, 2, -1), v(1, 1, 1));
    assertNear(v(-StrictMath.atan2(5, 3), 0, -StrictMath.atan2(4, 3)), v(hit.sx, hit.sy, hit.sz));
  }

  @Test
  void cornersAtOnePlaceShareEvenIfTheirPointsAreTwo() {
    double[] points = new double[36];
    int[] corners = new int[12];
    for (int i = 0; i < 12; i++) {
      System.arraycopy(ROOF, 3 * ROOF_CORNERS[i], points, 3 * i, 3);
      corners[i] = i;
    }
    points[0] = -0.0;
    Mesh apart = new Mesh(points, corners).smoothed(100);
    assertNear(v(0, 0, 1), shading(apart, Transform.IDENTITY, 0, 0.5));
  }

  @Test
  void smoothingGroupsShareWhateverTheAngle() {
    Mesh one = roof().withNormals(CornerValues.NONE, new int[] {7, 7, 7, 7});
    assertNear(v(0, 0, 1), shading(one, Transform.IDENTITY, 0, 0.5));
    Mesh two = roof().withNormals(CornerValues.NONE, new int[] {1, 1, 2, 2});
    assertNear(v(1, 0, 1), shading(two, Transform.IDENTITY, 0.01, 0.5));
    assertFalse(roof().withNormals(CornerValues.NONE, new int[4]).isSmooth());
  }

  @Test
  void cornersWithoutNormalTakeTheirFacesIfAnotherHasOne() {
    double[] values = {0, 0, 3e-200, 0, 0, 0};
    int[] some = {0, -1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
    Mesh mesh = roof().withNormals(normals(values, some), new int[4]);
    assertNear(v(0, 0, 1), shading(mesh, Transform.IDENTITY, 1e-17, 1e-17));
    assertNear(v(1, 0, 1), shading(mesh, Transform.IDENTITY, 1, 0.5));
    double half = Math.sqrt(0.5);
    assertNear(v(half, 0, 1 + half), shading(mesh, Transform.IDENTITY, 0.5, 0));
    assertNear(v(-1, 0, 1), shading(mesh, Transform.IDENTITY, -0.1, 0.5));
  }

  @Test
  void normalsFaceTheViewerWhicheverWayTheModelHasThem() {
    double[] inward = {0, 0, -1};
    int[] all = new int[12];
    Mesh mesh = roof().withNormals(normals(inward, all), new int[4]);
    assertNear(v(0, 0, 1), shading(mesh, Transform.IDENTITY, 0.3, 0.4));
    Hit below = hit(mesh, Transform.IDENTITY, v(0.3, 0.4, -9), v(0, 0, 1));
    assertNear(v(0, 0, -1), v(below.sx, below.sy, below.sz));
    assertNear(v(-1, 0, -1), v(below.nx, below.ny, below.nz));
  }

  /** Q07: a ball's normals, carried, are an ellipsoid's: square to its tangents. */
  @Property(tries = 200)
  void normalsAreCarriedByTheInverseTranspose(
      @ForAll @DoubleRange(min = -1, max = 1) double x,
      @ForAll @DoubleRange(min = -1, max = 1) double y,
      @ForAll boolean mirrored) {
    double[] points = {-2, -2, 0.5, 2, -2, 0.5, 0, 4, 0.5};
    int[] corners = {0, 1, 2};
    Mesh mesh = new Mesh(points, corners).withNormals(normals(points.clone(), 0, 1, 2), new int[1]);
    Vector3d factors = v(mirrored ? -1 : 1, 10, 0.1);
    Transform map =
        Transform.scale(factors)
            .then(Transform.rotate(Quaternion.aboutAxis(v(3, -1, 2), 77)))
            .then(Transform.translate(v(5, -6, 7)));
    Vector3d target = map.point(v(x / 2, y / 2, 0.5));
    Vector3d eye = map.point(v(0.3, 0.1, 20));
    Hit hit = hit(mesh, map, eye, target.minus(eye));
    Vector3d n = v(hit.sx, hit.sy, hit.sz);
    Vector3d unit = map.inverted().point(v(hit.px, hit.py, hit.pz));
    // The corners' unit normals, not their points, are what is mixed.
    double a = 1 / Math.sqrt(8.25);
    double top = 1 / Math.sqrt(16.25);
    double w = (unit.y() + 2) / 6;
    Vector3d mixed = v(unit.x() * a, -2 * a * (1 - w) + 4 * top * w, 0.5 * (a * (1 - w) + top * w));
    for (Vector3d tangent : new Vector3d[] {mixed.cross(v(1, 0, 0)), mixed.cross(v(0, 1, 0))}) {
      assertEquals(0, map.direction(tangent).normalized().dot(n), 1e-12);
    }
    assertTrue(n.dot(eye.minus(target)) > 0);
  }

  @Test
  void shadowRaysLeaveFromTheCurve() {
    double[] points = {-1, 0, 0, 1, 0, 0, 0, 1, 0};
    double[] normals = {-1, 0, 1, 1, 0, 1, 0, 0, 1};
    int[] corners = {0, 1, 2};
    Mesh mesh = new Mesh(points, corners).withNormals(normals(normals, corners), new int[1]);
    Ray ray = new Ray();
    Hit hit = hit(mesh, Transform.IDENTITY, v(0, 0, 3), v(0, 0, -1));
    hit.spawnToLight(0, 0, 1, ray);
    // Both ends' tangent planes are met at a height of 1/2, half of each.
    assertArrayEquals(new double[] {0, 0, 0.5}, new double[] {ray.ox, ray.oy, ray.oz}, 1e-14);
    hit = hit(mesh, Transform.translate(v(0, 0, 1)), v(0, 0, -3), v(0, 0, 1));
    hit.spawnToLight(0, 0, -1, ray);
    assertArrayEquals(new double[] {0, 0, 1}, new double[] {ray.ox, ray.oy, ray.oz}, 1e-14);
  }

  @Test
  void trianglesWithoutAreaAndNormalsOfNothingDoNoHarm() {
    double[] points = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0};
    Mesh mesh = new Mesh(points, new int[] {0, 1, 2, 0, 2, 3}).smoothed(180);
    assertNear(v(0, 0, 1), shading(mesh, Transform.IDENTITY, 0.1, 0.1));
    assertThrows(BadValueException.class, () -> normals(new double[] {0, 0, Double.NaN}, 0, 0, 0));
    assertThrows(BadValueException.class, () -> normals(new double[3], 0, 1, 0));
    assertThrows(
        IllegalArgumentException.class,
        () -> roof().withNormals(normals(new double[3], 0, 0, 0), new int[4]));
  }
}
