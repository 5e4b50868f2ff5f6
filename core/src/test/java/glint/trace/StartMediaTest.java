package glint.trace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Mesh;
import glint.geometry.Quad;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.NamedMaterial;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import glint.scene.View;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Which media a camera ray is in when it starts: relative error 1e-12. */
class StartMediaTest {

  private static final double SIGMA = 0.5;
  private static final Projection NARROW = Projection.vertical(1e-9);

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Material medium(double ior, double sigma, int priority) {
    Medium inside = new Medium(ior, Rgb.grey(sigma), priority);
    return new Material(
        Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK, Rgb.WHITE, inside);
  }

  private static Placement smoke(Surface surface) {
    return Placement.of(surface, medium(1, SIGMA, 0));
  }

  /** The octahedron with corners at distance 1 on the axes. */
  private static Mesh octahedron() {
    return new Mesh(OCTAHEDRON, OCTAHEDRON_FACES);
  }

  private static final double[] OCTAHEDRON = {
    1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1
  };
  private static final int[] OCTAHEDRON_FACES = {
    0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5
  };

  /** Returns what a pixel's centre sees along -z in a white field. */
  private static double seen(Camera camera, int size, int x, int y, Placement... placements) {
    Scene.Builder scene =
        new Scene.Builder("start").camera(camera).background(Background.constant(Rgb.WHITE));
    for (Placement placement : placements) {
      scene.place(placement);
    }
    Tracer tracer = new Tracer(Prepared.of(scene.build()), 20, 0x1p-50);
    Ray ray = new Ray();
    double end = new View(camera, size, size).ray(x + 0.5, y + 0.5, ray);
    tracer.trace(ray, end);
    return tracer.r;
  }

  private static Camera at(Vector3d eye, Projection projection, double near) {
    return new Camera(
        eye, eye.plus(v(0, 0, -1)), v(0, 1, 0), projection, near, Double.POSITIVE_INFINITY);
  }

  private static void assertFaded(double length, double actual) {
    double expected = StrictMath.exp(-SIGMA * length);
    assertEquals(expected, actual, 1e-12 * expected);
  }

  @Test
  void whatLiesBeforeTheNearPlaneIsCrossed() {
    Placement ball = smoke(new Sphere(Vector3d.ZERO, 2));
    assertFaded(4, seen(at(v(0, 0, 5), NARROW, 0), 1, 0, 0, ball));
    assertFaded(4, seen(at(v(0, 0, 5), NARROW, 2.5), 1, 0, 0, ball));
    assertFaded(1.5, seen(at(v(0, 0, 5), NARROW, 5.5), 1, 0, 0, ball));
    assertFaded(0, seen(at(v(0, 0, 5), NARROW, 7.5), 1, 0, 0, ball));
    assertFaded(1, seen(at(v(0, 0, 1), NARROW, 2), 1, 0, 0, ball));
    assertFaded(0, seen(at(v(0, 0, 1), NARROW, 3.5), 1, 0, 0, ball));
  }

  @Test
  void somethingOpaqueBeforeTheNearPlaneHidesNoMedium() {
    Placement ball = smoke(new Sphere(Vector3d.ZERO, 2));
    Placement wall = Placement.of(new Quad(v(-1, -1, 3), v(2, 0, 0), v(0, 2, 0)), Material.WHITE);
    Placement lid = Placement.of(new Quad(v(-1, -1, 2), v(2, 0, 0), v(0, 2, 0)), Material.WHITE);
    assertFaded(1.5, seen(at(v(0, 0, 5), NARROW, 5.5), 1, 0, 0, ball, wall));
    assertFaded(1.5, seen(at(v(0, 0, 5), NARROW, 5.5), 1, 0, 0, lid, ball));
    // The ball is known from the start: a smaller one, twice as dense, is entered from within it.
    Placement small = Placement.of(new Sphere(v(0, 0, -1), 0.25), medium(1, 2 * SIGMA, 0));
    assertFaded(2, seen(at(v(0, 0, 5), NARROW, 5.5), 1, 0, 0, ball, wall, small));
    assertFaded(2, seen(at(v(0, 0, 5), NARROW, 5.5), 1, 0, 0, ball, lid, small));
  }

  @Test
  void everyRayOfAnOrthographicCameraHasItsOwnMedia() {
    Placement ball = smoke(new Sphere(v(3, 0, 0), 1));
    // Pixels are 1 wide: their centres lie at x = -4, -3, ..., 4.
    Projection plane = new Orthographic(9);
    assertFaded(0, seen(at(v(0, 0, 0), plane, 0), 9, 4, 4, ball));
    assertFaded(1, seen(at(v(0, 0, 0), plane, 0), 9, 7, 4, ball));
    assertFaded(0.5, seen(at(v(0, 0, 0), plane, 0.5), 9, 7, 4, ball));
    assertFaded(1, seen(at(v(3, 0, 0), plane, 0), 9, 4, 4, ball));
    assertFaded(0, seen(at(v(3, 0, 0), plane, 0), 9, 1, 4, ball));
    Placement other = Placement.of(new Sphere(v(-3, 0, -2), 2.5), medium(1, 2 * SIGMA, 0));
    assertFaded(9, seen(at(v(1, 0, 0), plane, 0), 9, 0, 4, ball, other));
    Placement around = Placement.of(new Sphere(v(1, 0, 0), 1), medium(1, SIGMA, 0));
    assertFaded(9, seen(at(v(1, 0, 0), plane, 0), 9, 0, 4, around, other));
  }

  @Test
  void theIndexAtTheStartDecidesWhatIsReflected() {
    // From glass of 1.5 into air, seen from within: at normal incidence 4 % come back.
    Placement glass = Placement.of(new Box(v(-9, -9, -1), v(9, 9, 9)), medium(1.5, 0, 0));
    Placement air = Placement.of(new Box(v(-9, -9, -1), v(9, 9, -0.5)), medium(1, 0, 1));
    Placement wall = Placement.of(new Box(v(-99, -99, -3), v(99, 99, -2)), Material.WHITE);
    for (Projection projection : new Projection[] {NARROW, new Orthographic(9)}) {
      // What is reflected at z = -0.5 leaves through z = 9 and is reflected there again.
      double loop = 0.04 * 0.96 / (1 - 0.04 * 0.04);
      double seen = seen(at(v(0, 0, 1), projection, 0), 9, 4, 4, glass, air, wall);
      assertEquals(loop, seen, 1e-12);
    }
  }

  @Test
  void aRayThatOnlyTouchesABodyDoesNotDecideWhetherTheEyeIsInIt() {
    Placement ball = smoke(new Sphere(v(0, 0, 0), 1));
    assertFaded(0, seen(at(v(-5, 1, 0), NARROW, 0), 1, 0, 0, ball));
    Placement stone = smoke(octahedron());
    for (Vector3d eye : new Vector3d[] {v(-5, 1, 0), v(-5, 0, 1), v(5, 0, -1), v(0, -5, 1)}) {
      assertFaded(0, seen(at(eye, NARROW, 0), 1, 0, 0, stone));
    }
    assertFaded(1, seen(at(v(0, 0, 0), NARROW, 0), 1, 0, 0, stone));
    assertFaded(0.75, seen(at(v(0.25, 0, 0), NARROW, 0), 1, 0, 0, stone));
  }

  @Test
  void aMeshWithAnOpenEdgeIsASheet() {
    Mesh open = new Mesh(OCTAHEDRON, Arrays.copyOfRange(OCTAHEDRON_FACES, 3, 24));
    Placement[] closed = {smoke(octahedron())};
    Placement[] sheet = {smoke(open)};
    // What is missing is the face of x, y, z > 0; the eye is in the middle, or comes in by there.
    assertFaded(1, seenIn(closed));
    assertFaded(1, seenIn(sheet));
    Prepared around = Prepared.of(scene(sheet));
    assertEquals(0, around.mediaAtEye().length);
    assertTrue(around.isOpen(0));
    assertEquals(1, Prepared.of(scene(closed)).mediaAtEye().length);
    assertFaded(1.4, seen(at(v(0.125, 0.175, 5), NARROW, 0), 1, 0, 0, closed));
    assertFaded(0.7, seen(at(v(0.125, 0.175, 0), NARROW, 0), 1, 0, 0, sheet));
  }

  private static Scene scene(Placement... placements) {
    Scene.Builder scene = new Scene.Builder("eye").camera(at(Vector3d.ZERO, NARROW, 0));
    for (Placement placement : placements) {
      scene.place(placement);
    }
    return scene.build();
  }

  @Test
  void theMediaAtTheEyeAreOutermostFirst() {
    Placement large = Placement.of(new Sphere(v(0, 0, 0), 3), medium(1, 1, 0));
    Placement small = Placement.of(new Sphere(v(0.5, 0, 0), 1), medium(1, 2, 0));
    Scene.Builder scene = new Scene.Builder("eye").camera(at(Vector3d.ZERO, NARROW, 0));
    Prepared inner = Prepared.of(scene.place(small).place(large).build());
    assertArrayEquals(new int[] {inner.mediumOf(1), inner.mediumOf(0)}, inner.mediaAtEye());
    assertFaded(2 * 2 * Math.sqrt(0.75) + 2 * (3 - Math.sqrt(0.75)), seenIn(small, large));
    assertFaded(2 * 2 * Math.sqrt(0.75) + 2 * (3 - Math.sqrt(0.75)), seenIn(large, small));
  }

  private static double seenIn(Placement... bodies) {
    return seen(at(Vector3d.ZERO, NARROW, 0), 1, 0, 0, bodies);
  }

  @Test
  void anEdgeBetweenTwoTrianglesOfAFaceIsCrossedOnce() {
    // The rays go in through a diagonal and come out beside one, or the other way round.
    Placement front = smoke(new Quad(v(-1, -1, 0), v(2, 0, 0), v(0, 2, 0)));
    Placement back = smoke(new Quad(v(-1.5, -1, -1), v(0, 2, 0), v(2, 0, 0)));
    assertFaded(1, seen(at(v(0, 0, 5), NARROW, 0), 1, 0, 0, front, back));
    assertFaded(1, seen(at(v(-0.5, 0, 5), NARROW, 0), 1, 0, 0, front, back));
    assertFaded(1, seen(at(v(0.25, 0, 5), NARROW, 0), 1, 0, 0, front, back));
    Placement stone = smoke(octahedron());
    assertFaded(1, seen(at(v(0.25, 0.25, 5), NARROW, 0), 1, 0, 0, stone));
    assertFaded(1.5, seen(at(v(0.25, 0, 5), NARROW, 0), 1, 0, 0, stone));
    assertFaded(2, seen(at(v(0, 0, 5), NARROW, 0), 1, 0, 0, stone));
  }

  @Test
  void aBodyInPartsIsLeftByTheMediumOfThePart() {
    Mesh half = octahedron().inParts(new int[] {0, 4}, new int[] {0, 1}); // above and below z = 0
    Material smoke = medium(1, SIGMA, 0);
    Placement both = parts(half, smoke, smoke);
    assertFaded(0.5, seen(at(v(0.1, 0.2, -0.2), NARROW, 0), 1, 0, 0, both));
    assertFaded(2 * 0.7, seen(at(v(0.1, 0.2, 5), NARROW, 0), 1, 0, 0, both));
    // Only the upper part lets light out; who looks up from inside is in its smoke.
    Camera up = Camera.of(v(0.1, 0.2, -0.2), v(0.1, 0.2, 9), v(0, 1, 0), NARROW);
    Material lamp = new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.WHITE);
    Placement within = Placement.of(new Sphere(v(0.1, 0.2, 0.25), 0.125), lamp);
    assertFaded(0.325, seen(up, 1, 0, 0, parts(half, smoke, Material.WHITE), within));
    // Below it, where the opaque part hides the upper one, nobody is.
    Camera below = Camera.of(v(0.1, 0.2, -2), v(0.1, 0.2, -9), v(0, 1, 0), NARROW);
    assertFaded(0, seen(below, 1, 0, 0, parts(half, smoke, Material.WHITE)));
  }

  private static Placement parts(Mesh mesh, Material first, Material second) {
    List<NamedMaterial> materials =
        List.of(new NamedMaterial("", first), new NamedMaterial("", second));
    return new Placement(mesh, Transform.IDENTITY, materials, 0);
  }
}
