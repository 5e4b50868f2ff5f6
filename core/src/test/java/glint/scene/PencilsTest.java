package glint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.accel.Intersector;
import glint.accel.Pencil;
import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.light.LightSample;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.sampling.SobolSampler;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** What starts at the eye and what ends at a light is of a pencil: no such ray walks the tree. */
class PencilsTest {

  private static final Vector3d EYE = new Vector3d(1, 2, 15);

  private static final Projection PERSPECTIVE = Projection.vertical(40);

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Camera camera(Vector3d eye, Projection projection, double radius) {
    Optional<Lens> lens = radius > 0 ? Optional.of(new Lens(radius, 10)) : Optional.empty();
    double far = Double.POSITIVE_INFINITY;
    return new Camera(eye, v(0.1, 0.2, 0.3), v(0, 1, 0), projection, 0, far, lens);
  }

  private static Scene balls(Camera camera, Light... lights) {
    Scene.Builder scene = new Scene.Builder("balls").size(16, 12).camera(camera);
    for (Light light : lights) {
      scene.light(light);
    }
    for (int i = 0; i < 27; i++) {
      Vector3d at = v(3 * (i % 3) - 3, 3 * (i / 3 % 3) - 3, 3 * (i / 9) - 3);
      scene.place(Placement.of(new Sphere(at, 1), Material.WHITE));
    }
    return scene.build();
  }

  /** Looks through a picture; returns how many rays meet something, without any tree. */
  private static int look(Prepared scene) {
    Intersector search = scene.intersector();
    Scene picture = scene.scene();
    View view = new View(picture.camera(), picture.width(), picture.height());
    Ray ray = new Ray();
    Hit hit = new Hit();
    int met = 0;
    for (double y = 0.7; y < picture.height(); y++) {
      for (double x = 0.3; x < picture.width(); x++) {
        double end = view.ray(x, y, ray);
        search.closest(ray, end, scene.pencils().fromEye(), hit);
        met += hit.found() ? 1 : 0;
      }
    }
    assertEquals(0, search.nodesVisited());
    return met;
  }

  @Test
  void raysFromTheEye() {
    Prepared seen = Prepared.of(balls(camera(EYE, PERSPECTIVE, 0)));
    assertTrue(seen.plan().tree().used());
    assertTrue(look(seen) > 50);
    assertTrue(look(Prepared.of(balls(camera(EYE, new Orthographic(9), 0)))) > 50);
    Scene other = seen.scene().seenBy(camera(v(15, 3, 2), PERSPECTIVE, 0), 16, 12);
    assertTrue(look(seen.seenIn(other)) > 50);
  }

  /** Of a mesh of many triangles rays begin at subtrees, and meet what they meet from the root. */
  @Test
  void subtreesOfMany() {
    int side = 101;
    double[] points = new double[3 * side * side];
    int[] corners = new int[6 * (side - 1) * (side - 1)];
    for (int i = 0; i < side * side; i++) {
      int row = i / side;
      points[3 * i] = (i % side) * 0.1 - 5;
      points[3 * i + 1] = StrictMath.sin(i % side) * StrictMath.cos(row);
      points[3 * i + 2] = row * 0.1 - 5;
    }
    for (int i = 0, at = 0; i < side * (side - 1); i++) {
      if (i % side < side - 1) {
        for (int corner : new int[] {i, i + 1, i + side, i + 1, i + side, i + side + 1}) {
          corners[at++] = corner;
        }
      }
    }
    Scene.Builder hills = new Scene.Builder("hills").size(40, 30);
    hills.camera(camera(EYE, PERSPECTIVE, 0));
    hills.place(Placement.of(new Mesh(points, corners), Material.WHITE));
    Prepared scene = Prepared.of(hills.build());
    Intersector listed = scene.intersector();
    Intersector plain = scene.intersector();
    View view = new View(scene.scene().camera(), 40, 30);
    Ray ray = new Ray();
    Hit a = new Hit();
    Hit b = new Hit();
    int met = 0;
    for (int i = 0; i < 40 * 30; i++) {
      int row = i / 40;
      double end = view.ray(i % 40 + 0.3, row + 0.7, ray);
      listed.closest(ray, end, scene.pencils().fromEye(), a);
      plain.closest(ray, end, b);
      assertEquals(b.primitive, a.primitive);
      assertEquals(b.t, a.t);
      met += a.found() ? 1 : 0;
    }
    assertTrue(met > 200, "met: " + met);
    assertTrue(3 * listed.nodesVisited() < 2 * plain.nodesVisited());
  }

  @Test
  void raysToLights() {
    Light[] lights = {
      new Light.Point(v(4, 9, 20), Rgb.WHITE, false),
      new Light.Spot(v(0, 12, 1), Vector3d.ZERO, Rgb.WHITE, 90, 0),
      new Light.Directional(v(-1, -2, -3), Rgb.WHITE)
    };
    Prepared scene = Prepared.of(balls(camera(EYE, PERSPECTIVE, 0), lights));
    Intersector search = scene.intersector();
    Ray ray = new Ray();
    Hit hit = new Hit();
    LightSample sample = new LightSample();
    int shadowed = 0;
    for (int i = 0; i < lights.length; i++) {
      Pencil pencil = scene.pencils().toLight(i);
      for (double x = -4; x <= 4; x += 0.5) {
        hit.begin(1);
        hit.px = x;
        hit.py = -0.5 * x;
        hit.pz = 0.7 * x;
        assertTrue(scene.lights().at(i, hit, new SobolSampler(0), 0, sample));
        double end = scene.lights().shadowRay(i, sample, hit, ray);
        shadowed += search.blocker(ray, end, pencil, -1, hit) >= 0 ? 1 : 0;
      }
    }
    assertEquals(0, search.nodesVisited());
    assertTrue(shadowed > 10, "shadowed: " + shadowed);
  }

  @Test
  void whatSharesNoEndHasNone() {
    Light lamp = new Light.Sphere(v(9, 9, 9), 1, Rgb.WHITE);
    Prepared blurred = Prepared.of(balls(camera(EYE, PERSPECTIVE, 0.1), lamp));
    assertFalse(blurred.plan().pencils().used());
    assertNull(blurred.pencils().fromEye());
    assertNull(blurred.pencils().toLight(0));
    Light point = new Light.Point(v(9, 9, 9), Rgb.WHITE, false);
    Prepared lit = Prepared.of(balls(camera(EYE, PERSPECTIVE, 0.1), lamp, point));
    assertTrue(lit.plan().pencils().used());
    assertNull(lit.pencils().fromEye());
    assertNull(lit.pencils().toLight(0));
    assertNotNull(lit.pencils().toLight(1));
  }

  @Test
  void ofManyLightsSixtyFourHaveLists() {
    Light[] lights = new Light[70];
    for (int i = 0; i < lights.length; i++) {
      Vector3d at = v(i, 9, 9);
      lights[i] =
          i == 0 ? new Light.Sphere(at, 1, Rgb.WHITE) : new Light.Point(at, Rgb.WHITE, false);
    }
    Prepared scene = Prepared.of(balls(camera(EYE, PERSPECTIVE, 0), lights));
    assertNotNull(scene.pencils().toLight(64));
    assertNull(scene.pencils().toLight(65));
    String reason = scene.plan().pencils().reason();
    assertEquals("lists of what rays can meet: to lights: 64, and from the eye", reason);
  }
}
