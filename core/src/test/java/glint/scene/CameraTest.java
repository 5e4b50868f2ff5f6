package glint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import glint.geometry.Ray;
import glint.math.BadValueException;
import glint.math.Vector3d;
import org.junit.jupiter.api.Test;

/** Cases C01 to C05: rays are exactly where the projection says, and mirror bit for bit. */
class CameraTest {

  private static final Vector3d UP = new Vector3d(0, 1, 0);
  private static final double U = 0x1p-53;

  private static Camera looking(Vector3d from, Vector3d to, Projection projection) {
    return Camera.of(from, to, UP, projection);
  }

  @Test
  void theCentrePixelLooksStraightAhead() {
    Vector3d eye = new Vector3d(1, 2, 3);
    Vector3d target = new Vector3d(-4, 0.5, -7);
    View view = new View(looking(eye, target, Projection.vertical(50)), 641, 481);
    Vector3d forward = target.minus(eye).normalized();
    Ray ray = new Ray();
    view.ray(320.5, 240.5, ray);
    assertEquals(forward.x(), ray.dx, Math.ulp(forward.x()));
    assertEquals(forward.y(), ray.dy, Math.ulp(forward.y()));
    assertEquals(forward.z(), ray.dz, Math.ulp(forward.z()));
  }

  @Test
  void aRightAngleOfViewGivesExactTangents() {
    View view =
        new View(looking(Vector3d.ZERO, new Vector3d(0, 0, -1), Projection.vertical(90)), 640, 480);
    Ray ray = new Ray();
    for (int y = 0; y < 480; y++) {
      view.ray(0.5, y + 0.5, ray);
      double tangent = (480 - 2 * y - 1) / 480.0;
      assertEquals(tangent, ray.dy / -ray.dz, 2 * U);
      double across = (1 - 640) / 640.0 * (640.0 / 480.0);
      assertEquals(across, ray.dx / -ray.dz, 8 * U);
    }
  }

  @Test
  void theViewIsMirroredBitForBit() {
    Vector3d eye = new Vector3d(0.3, 1.7, 5);
    Vector3d target = new Vector3d(-1, 0.2, 0.1);
    View view = new View(looking(eye, target, Projection.vertical(37)), 33, 20);
    View mirrored = new View(looking(mirror(eye), mirror(target), Projection.vertical(37)), 33, 20);
    Ray a = new Ray();
    Ray b = new Ray();
    for (int x = 0; x < 33; x++) {
      for (int y = 0; y < 20; y++) {
        view.ray(x + 0.5, y + 0.5, a);
        mirrored.ray(32 - x + 0.5, y + 0.5, b);
        assertEquals(a.dx, -b.dx);
        assertEquals(a.dy, b.dy);
        assertEquals(a.dz, b.dz);
      }
    }
  }

  @Test
  void aHorizontalAngleSpansTheWidth() {
    View view =
        new View(
            looking(Vector3d.ZERO, new Vector3d(0, 0, -1), new Perspective(90, true, 0)), 200, 100);
    Ray ray = new Ray();
    view.ray(0, 50, ray);
    assertEquals(-1, ray.dx / -ray.dz, 2 * U);
    view.ray(100, 0, ray);
    assertEquals(0.5, ray.dy / -ray.dz, 2 * U);
  }

  @Test
  void clippingIsMeasuredAlongTheView() {
    Camera camera =
        new Camera(Vector3d.ZERO, new Vector3d(0, 0, -1), UP, Projection.vertical(90), 2, 10);
    Ray ray = new Ray();
    double end = new View(camera, 100, 100).ray(0, 0, ray);
    assertEquals(-2, ray.tMin * ray.dz, 4 * U);
    assertEquals(-10, end * ray.dz, 16 * U);
  }

  @Test
  void anOrthographicRayStartsOnThePlaneThroughTheEye() {
    Vector3d eye = new Vector3d(1, 2, 3);
    Camera camera = new Camera(eye, new Vector3d(1, 2, -4), UP, new Orthographic(6), 0.5, 9);
    View view = new View(camera, 12, 6);
    Ray ray = new Ray();
    for (int x = 0; x < 12; x++) {
      for (int y = 0; y < 6; y++) {
        assertEquals(9, view.ray(x + 0.5, y + 0.5, ray));
        assertEquals(0.5, ray.tMin);
        assertEquals(1 + (x - 5.5), ray.ox);
        assertEquals(2 + (2.5 - y), ray.oy);
        assertEquals(3, ray.oz);
        assertEquals(0, ray.dx);
        assertEquals(0, ray.dy);
        assertEquals(-1, ray.dz);
      }
    }
  }

  @Test
  void anOrthographicViewIsMirroredBitForBit() {
    Vector3d eye = new Vector3d(0.3, 1.7, 5);
    Vector3d target = new Vector3d(-1, 0.2, 0.1);
    View view = new View(looking(eye, target, new Orthographic(3.7)), 33, 20);
    View mirrored = new View(looking(mirror(eye), mirror(target), new Orthographic(3.7)), 33, 20);
    Ray a = new Ray();
    Ray b = new Ray();
    for (int x = 0; x < 33; x++) {
      for (int y = 0; y < 20; y++) {
        view.ray(x + 0.5, y + 0.5, a);
        mirrored.ray(32 - x + 0.5, y + 0.5, b);
        assertEquals(new Vector3d(a.ox, a.oy, a.oz), mirror(new Vector3d(b.ox, b.oy, b.oz)));
        assertEquals(new Vector3d(a.dx, a.dy, a.dz), mirror(new Vector3d(b.dx, b.dy, b.dz)));
      }
    }
  }

  @Test
  void aCameraWithoutADirectionIsRefused() {
    Projection lens = Projection.vertical(40);
    Vector3d eye = new Vector3d(1, 1, 1);
    assertRefused("look_at", () -> looking(eye, eye, lens));
    assertRefused("up", () -> looking(eye, new Vector3d(1, 5, 1), lens));
    assertRefused("up", () -> looking(eye, new Vector3d(1, -5, 1), lens));
    assertRefused("fov", () -> Projection.vertical(180));
    assertRefused("fov", () -> Projection.vertical(Double.NaN));
    assertRefused("orthographic", () -> new Orthographic(0));
    assertRefused("near", () -> new Camera(eye, Vector3d.ZERO, UP, lens, 5, 5));
    assertRefused("position", () -> looking(new Vector3d(Double.NaN, 0, 0), eye, lens));
  }

  private static void assertRefused(String field, Runnable maker) {
    assertEquals(field, assertThrows(BadValueException.class, maker::run).field());
  }

  private static Vector3d mirror(Vector3d v) {
    return new Vector3d(-v.x(), v.y(), v.z());
  }
}
