package glint.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Plane;
import glint.geometry.Quad;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.Highlight;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import org.junit.jupiter.api.Test;

/** The radiance of single rays against closed forms: one ray, relative error 1e-12 unless said. */
class ShadingTest {

  private static final Plane FLOOR = new Plane(Vector3d.ZERO, new Vector3d(0, 1, 0));
  private static final Material WHITE = material(0, 1, 0, 1, 0, 0);

  private static Material material(
      double ambient, double diffuse, double specular, double n, double mirror, double emission) {
    return new Material(
        Rgb.grey(ambient),
        Rgb.grey(diffuse),
        Rgb.grey(specular),
        n,
        Rgb.grey(mirror),
        Rgb.grey(emission));
  }

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Scene.Builder scene() {
    Camera camera = Camera.of(v(0, 5, 9), Vector3d.ZERO, v(0, 1, 0), Projection.vertical(40));
    return new Scene.Builder("test").camera(camera);
  }

  /** The red channel of the ray from one point towards another. */
  private static double radiance(Scene.Builder scene, int depth, Vector3d from, Vector3d to) {
    Tracer tracer = new Tracer(Prepared.of(scene.build()), depth, 0.05 / (255 * 12.92));
    Vector3d d = to.minus(from).normalized();
    Ray ray = new Ray();
    ray.set(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
    tracer.trace(ray, Double.POSITIVE_INFINITY);
    return tracer.r;
  }

  private static void assertClose(double expected, double actual) {
    assertEquals(expected, actual, 1e-12 * Math.abs(expected));
  }

  @Test
  void aPointLightOverAFloorFallsOffAsItIsTold() {
    double h = 3;
    for (double x : new double[] {0, 0.5, 2, 17}) {
      Vector3d at = v(x, 0, 0);
      Vector3d eye = v(0, 5, 9);
      Scene.Builder inverse = scene().light(new Light.Point(v(0, h, 0), Rgb.grey(7), true));
      double distance = Math.sqrt(h * h + x * x);
      assertClose(
          7 * h / (distance * distance * distance),
          radiance(inverse.place(Placement.of(FLOOR, WHITE)), 0, eye, at));
      Scene.Builder none = scene().light(new Light.Point(v(0, h, 0), Rgb.grey(7), false));
      assertClose(7 * h / distance, radiance(none.place(Placement.of(FLOOR, WHITE)), 0, eye, at));
    }
  }

  @Test
  void aSphereUnderParallelLightIsLambertian() {
    double phase = 0.7;
    Light sun =
        new Light.Directional(v(-StrictMath.sin(phase), 0, -StrictMath.cos(phase)), Rgb.grey(2));
    Scene.Builder ball = scene().light(sun).place(Placement.of(new Sphere(v(0, 0, 0), 2), WHITE));
    for (double x : new double[] {-1.2, 0, 0.9, 1.9}) {
      double z = Math.sqrt(4 - x * x);
      double expected = 2 * Math.max(0, x * StrictMath.sin(phase) + z * StrictMath.cos(phase)) / 2;
      assertClose(expected, radiance(ball, 0, v(x, 0, 50), v(x, 0, 0)));
    }
  }

  @Test
  void parallelMirrorsThatGlowAddUpTheirGeometricSeries() {
    double k = 0.75;
    double e = 0.3;
    Material glowing = material(0, 0, 0, 1, k, e);
    Plane ceiling = new Plane(v(0, 2, 0), v(0, -1, 0));
    Scene.Builder hall =
        scene().place(Placement.of(FLOOR, glowing)).place(Placement.of(ceiling, glowing));
    for (int depth = 0; depth < 20; depth++) {
      double expected = e * (1 - StrictMath.pow(k, depth + 1)) / (1 - k);
      assertClose(expected, radiance(hall, depth, v(0.1, 1, 0.2), v(0.1, 0, 0.2)));
    }
    // Without a limit of its own the cut-off loses less than a twentieth of a display level.
    double all = radiance(hall, 64, v(0.1, 1, 0.2), v(0.1, 0, 0.2));
    assertEquals(e / (1 - k), all, 0.05 / 255);
  }

  @Test
  void highlightsFollowBlinnAndPhong() {
    Material shiny = material(0, 0, 0.8, 20, 0, 0);
    Light lamp = new Light.Directional(v(0, -1, 0), Rgb.WHITE);
    // Seen at angle a from the normal along which the light falls: h is at a/2, r·v = cos a.
    double a = 0.6;
    Vector3d eye = v(4 * StrictMath.sin(a), 4 * StrictMath.cos(a), 0);
    Scene.Builder blinn = scene().light(lamp).place(Placement.of(FLOOR, shiny));
    assertClose(
        0.8 * StrictMath.pow(StrictMath.cos(a / 2), 20), radiance(blinn, 0, eye, v(0, 0, 0)));
    Scene.Builder phong =
        scene().light(lamp).place(Placement.of(FLOOR, shiny)).highlight(Highlight.PHONG);
    assertClose(0.8 * StrictMath.pow(StrictMath.cos(a), 20), radiance(phong, 0, eye, v(0, 0, 0)));
  }

  @Test
  void aSpotFadesFromCoreToRim() {
    // At height 1 the half angle of 45° reaches radius 1, and half of it tan(22.5°).
    Light spot = new Light.Spot(v(0, 1, 0), Vector3d.ZERO, Rgb.WHITE, 90, 0.5);
    Scene.Builder floor = scene().light(spot).place(Placement.of(FLOOR, WHITE));
    Vector3d eye = v(0, 5, 9);
    assertClose(1, radiance(floor, 0, eye, v(0, 0, 0)));
    assertClose(1 / Math.sqrt(1 + 0.16), radiance(floor, 0, eye, v(0.4, 0, 0)));
    assertEquals(0, radiance(floor, 0, eye, v(1.01, 0, 0)));
    double half = radiance(floor, 0, eye, v(0.7, 0, 0)) * Math.sqrt(1.49);
    double outer = StrictMath.cos(StrictMath.PI / 4);
    double s = (1 / Math.sqrt(1.49) - outer) / (StrictMath.cos(StrictMath.PI / 8) - outer);
    assertClose(s * s * (3 - 2 * s), half);
  }

  @Test
  void aBallsShadowIsTheEllipseThatGeometrySays() {
    Vector3d toLight = v(StrictMath.sin(0.5), StrictMath.cos(0.5), 0);
    Vector3d center = v(0, 2, 0);
    Scene.Builder floor =
        scene()
            .light(new Light.Directional(toLight.negated(), Rgb.WHITE))
            .place(Placement.of(FLOOR, WHITE))
            .place(Placement.of(new Sphere(center, 1), WHITE));
    int dark = 0;
    for (int i = -60; i <= 60; i++) {
      for (int j = -40; j <= 40; j++) {
        Vector3d p = v(i / 20.0, 0, j / 20.0 + 0.003);
        boolean inShadow = p.minus(center).cross(toLight).length() < 1;
        double seen = radiance(floor, 0, v(p.x(), 1e-3, p.z()), p);
        assertClose(inShadow ? 0 : toLight.y(), seen);
        dark += inShadow ? 1 : 0;
      }
    }
    assertEquals(StrictMath.PI / StrictMath.cos(0.5), dark / 400.0, 0.05);
  }

  @Test
  void nothingBeyondALightCastsAShadow() {
    Scene.Builder beyond = underQuadAt(2 * (1 + 1e-12));
    assertClose(1, radiance(beyond, 0, v(0, 0.5, 0), Vector3d.ZERO));
    Scene.Builder before = underQuadAt(2 * (1 - 1e-9));
    assertEquals(0, radiance(before, 0, v(0, 0.5, 0), Vector3d.ZERO));
  }

  private static Scene.Builder underQuadAt(double height) {
    Quad roof = new Quad(v(-1, height, -1), v(2, 0, 0), v(0, 0, 2));
    return scene()
        .light(new Light.Point(v(0, 2, 0), Rgb.WHITE, false))
        .place(Placement.of(FLOOR, WHITE))
        .place(Placement.of(roof, material(0, 0, 0, 1, 0, 0)));
  }

  @Test
  void lightOnTheHorizonOrAtThePointGivesNothing() {
    Material shiny = material(0, 1, 1, 0, 0, 0);
    Scene.Builder horizon =
        scene()
            .light(new Light.Directional(v(1, 0, 0), Rgb.WHITE))
            .light(new Light.Point(v(0, 0, 0), Rgb.WHITE, true))
            .place(Placement.of(FLOOR, shiny));
    assertEquals(0, radiance(horizon, 0, v(0, 3, 0), v(0, 0, 0)));
  }

  @Test
  void noLightLeaksIntoASealedRoom() {
    Material wall = material(0.25, 1, 1, 10, 0, 0);
    Scene.Builder room =
        scene()
            .light(new Light.Ambient(Rgb.WHITE))
            .light(new Light.Point(v(1, 9, 2), Rgb.WHITE, false))
            .light(new Light.Directional(v(1, -1, 1), Rgb.WHITE))
            .place(Placement.of(new Box(v(-1, -1, -1), v(1, 1, 1)), wall));
    for (int i = 0; i < 2000; i++) {
      double a = i * 2.399963;
      double y = -1 + (2 * i + 1) / 2000.0;
      double s = Math.sqrt(1 - y * y);
      Vector3d d = v(s * StrictMath.cos(a), y, s * StrictMath.sin(a));
      assertEquals(0.25, radiance(room, 0, v(0.3, 0.2, -0.1), v(0.3, 0.2, -0.1).plus(d)));
    }
  }

  @Test
  void theSkyIsBlendedByHeight() {
    Scene.Builder sky = scene().background(new Background(Rgb.grey(0.2), Rgb.grey(1)));
    assertClose(0.2 + 0.8 * (1 + 0.6) / 2, radiance(sky, 0, Vector3d.ZERO, v(0.8, 0.6, 0)));
  }
}
