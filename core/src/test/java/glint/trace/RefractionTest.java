package glint.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Plane;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.Fresnel;
import glint.optics.Material;
import glint.optics.Medium;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import org.junit.jupiter.api.Test;

/** Glass against closed forms: single rays, relative error 1e-12 unless said. */
class RefractionTest {

  private static final int DEEP = 200;

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Material glass(double ior, Rgb absorption, int priority) {
    return filter(1, new Medium(ior, absorption, priority));
  }

  private static Material glass(double ior) {
    return glass(ior, Rgb.BLACK, 0);
  }

  private static Material filter(double transparency, Medium interior) {
    return new Material(
        Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK, Rgb.grey(transparency), interior);
  }

  private static Material glowing(double emission) {
    return new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.grey(emission));
  }

  /** A scene seen from far outside, in a field of radiance 1. */
  private static Scene.Builder field(Vector3d eye) {
    return new Scene.Builder("test")
        .camera(Camera.of(eye, v(0.3, 0.2, 0.1), v(0, 1, 0.1), Projection.vertical(40)))
        .background(Background.constant(Rgb.WHITE));
  }

  private static Scene.Builder field() {
    return field(v(0, 0, 50));
  }

  private static Placement at(Surface surface, Material material) {
    return Placement.of(surface, material);
  }

  private static Tracer trace(Scene.Builder scene, int depth, Vector3d from, Vector3d direction) {
    Tracer tracer = new Tracer(Prepared.of(scene.build()), depth, 0x1p-40);
    Vector3d d = direction.normalized();
    Ray ray = new Ray();
    ray.set(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
    tracer.trace(ray, Double.POSITIVE_INFINITY);
    return tracer;
  }

  private static void assertClose(double expected, double actual) {
    assertEquals(expected, actual, 1e-12 * Math.abs(expected));
  }

  private static double fresnel(double cos, double eta) {
    return Fresnel.reflectance(cos, Fresnel.cosOut(cos, eta), eta);
  }

  @Test
  void aLosslessBallInAFieldIsInvisibleAndItsDepthSeriesIsExact() {
    Scene.Builder ball = field().place(at(new Sphere(Vector3d.ZERO, 1), glass(1.5)));
    for (double b : new double[] {0, 0.3, 0.7, 0.9, 0.99, 0.999}) {
      double r = fresnel(Math.sqrt(1 - b * b), 1 / 1.5);
      assertEquals(1, trace(ball, DEEP, v(b, 0, 50), v(0, 0, -1)).r, 1e-9);
      for (int n = 1; n <= 32; n++) {
        Tracer tracer = trace(ball, n, v(b, 0, 50), v(0, 0, -1));
        double expected = 1 - (1 - r) * StrictMath.pow(r, n - 1); // one bounce goes in
        assertTrue(1 - tracer.r <= tracer.cut + 1e-12, "more is missing than is said");
        if (tracer.cut >= 1e-9) { // not cut off by its contribution before
          assertEquals(expected, tracer.r, 1e-9);
        }
      }
    }
  }

  @Test
  void aSlabSharesOutItsLightAsTheSeriesSays() {
    double sigma = 0.35;
    Box slab = new Box(v(-1e3, -1e3, -0.5), v(1e3, 1e3, 0.5));
    // Behind stands a glowing wall, before it the eye's side is the background of 1.
    Scene.Builder scene =
        field()
            .place(at(slab, glass(1.5, Rgb.grey(sigma), 0)))
            .place(at(new Plane(v(0, 0, -10), v(0, 0, 1)), glowing(0.25)));
    for (double angle : new double[] {0, 0.4, 1.2}) {
      Vector3d d = v(StrictMath.sin(angle), 0, -StrictMath.cos(angle));
      double r = fresnel(-d.z(), 1 / 1.5);
      double cosInside = Math.sqrt(1 - d.x() * d.x() / 2.25);
      double tau = StrictMath.exp(-sigma / cosInside);
      double thin = 1 - r * r * tau * tau;
      double expected =
          r + (1 - r) * (1 - r) * r * tau * tau / thin + 0.25 * (1 - r) * (1 - r) * tau / thin;
      assertEquals(expected, trace(scene, DEEP, v(0, 0, 20), d).r, 1e-7);
    }
    assertEquals(
        1.0 / 13 + 12.0 / 13,
        trace(field().place(at(slab, glass(1.5))), DEEP, v(0, 0, 20), v(0, 0, -1)).r,
        1e-7);
  }

  @Test
  void absorptionFollowsBeerAndLambert() {
    Rgb sigma = new Rgb(0.2, 1, 3);
    Scene.Builder ball = field().place(at(new Sphere(Vector3d.ZERO, 1), glass(1, sigma, 0)));
    for (double b : new double[] {0, 0.5, 0.95}) {
      double chord = 2 * Math.sqrt(1 - b * b);
      Tracer tracer = trace(ball, DEEP, v(b, 0, 50), v(0, 0, -1));
      assertClose(StrictMath.exp(-0.2 * chord), tracer.r);
      assertClose(StrictMath.exp(-chord), tracer.g);
      assertClose(StrictMath.exp(-3 * chord), tracer.b);
    }
  }

  @Test
  void absorptionAddsUpOverTouchingSlabs() {
    Material fog = glass(1, Rgb.grey(0.7), 0);
    Scene.Builder two =
        field()
            .place(at(new Box(v(-9, -9, 0), v(9, 9, 1)), fog))
            .place(at(new Box(v(-9, -9, 1), v(9, 9, 2)), glass(1, Rgb.grey(0.7), 1)));
    assertClose(StrictMath.exp(-1.4), trace(two, DEEP, v(0, 0, 50), v(0, 0, -1)).r);
    assertClose(StrictMath.exp(-1.4), trace(two, DEEP, v(0, 0, -50), v(0, 0, 1)).r);
  }

  @Test
  void twoSlabsThatShareAPlaneAreOne() {
    Background sky = new Background(Rgb.BLACK, Rgb.WHITE);
    Box whole = new Box(v(-9, -9, 0), v(9, 9, 2));
    Vector3d d = v(0.4, 0.3, -1);
    for (int priority : new int[] {0, 1}) {
      Scene.Builder one = field().background(sky).place(at(whole, glass(1.5)));
      Scene.Builder two =
          field()
              .background(sky)
              .place(at(new Box(v(-9, -9, 0), v(9, 9, 1)), glass(1.5)))
              .place(at(new Box(v(-9, -9, 1), v(9, 9, 2)), glass(1.5, Rgb.BLACK, priority)));
      assertEquals(trace(one, 12, v(0, 0, 9), d).r, trace(two, 12, v(0, 0, 9), d).r, 1e-12);
    }
  }

  @Test
  void aBallOfVacuumIsNotThere() {
    Background sky = new Background(new Rgb(0.1, 0.5, 0.2), Rgb.WHITE);
    Scene.Builder with = field().background(sky).place(at(new Sphere(Vector3d.ZERO, 1), glass(1)));
    Scene.Builder without = field().background(sky);
    for (int i = 0; i < 100; i++) {
      Vector3d d = v(0.02 * i - 1, 0.013 * i - 0.6, -3);
      assertEquals(
          trace(without, DEEP, v(0, 0, 3), d).r, trace(with, DEEP, v(0, 0, 3), d).r, 1e-15);
    }
  }

  @Test
  void overlappingMediaAreWhatTheirPrioritiesSay() {
    // Water in a glass: the water reaches into the glass wall, where glass has the priority.
    Background sky = new Background(Rgb.BLACK, Rgb.WHITE);
    Vector3d from = v(0, 0.3, 9);
    Vector3d d = v(0.11, 0.05, -1);
    Scene.Builder nested =
        field()
            .background(sky)
            .place(at(new Box(v(-2, -2, 1), v(2, 2, 2)), glass(1.5, Rgb.BLACK, 2)))
            .place(at(new Box(v(-2, -2, -2), v(2, 2, 1.5)), glass(1.33, Rgb.BLACK, 1)));
    Scene.Builder exact =
        field()
            .background(sky)
            .place(at(new Box(v(-2, -2, 1), v(2, 2, 2)), glass(1.5, Rgb.BLACK, 2)))
            .place(at(new Box(v(-2, -2, -2), v(2, 2, 1)), glass(1.33, Rgb.BLACK, 1)));
    for (int depth : new int[] {1, 2, 5, 20}) {
      assertEquals(trace(exact, depth, from, d).r, trace(nested, depth, from, d).r, 1e-12);
    }
  }

  @Test
  void theEyeMayBeInsideAMedium() {
    Material dark = glass(1, Rgb.grey(0.5), 0);
    Scene.Builder inside = field(v(0, 0, 0)).place(at(new Sphere(Vector3d.ZERO, 2), dark));
    assertClose(StrictMath.exp(-1), trace(inside, DEEP, Vector3d.ZERO, v(0.3, 0.2, 1)).r);
    Scene.Builder under = field(v(0, -3, 0)).place(at(new Plane(Vector3d.ZERO, v(0, 1, 0)), dark));
    assertClose(StrictMath.exp(-1.5), trace(under, DEEP, v(0, -3, 0), v(0, 1, 0)).r);
  }

  @Test
  void shadowsAreColouredByWhatTheLightGoesThrough() {
    Rgb sigma = new Rgb(0.3, 0.6, 2);
    Plane floor = new Plane(Vector3d.ZERO, v(0, 1, 0));
    Scene.Builder scene =
        field()
            .background(Background.BLACK)
            .light(new Light.Directional(v(0, -1, 0), Rgb.grey(0.8)))
            .place(at(floor, Material.WHITE))
            .place(at(new Sphere(v(0, 3, 0), 1), glass(1, sigma, 0)));
    for (double b : new double[] {0, 0.5, 0.9}) {
      double chord = 2 * Math.sqrt(1 - b * b);
      Tracer tracer = trace(scene, DEEP, v(b, 0.5, 0), v(0, -1, 0));
      assertClose(0.8 * StrictMath.exp(-0.3 * chord), tracer.r);
      assertClose(0.8 * StrictMath.exp(-0.6 * chord), tracer.g);
      assertClose(0.8 * StrictMath.exp(-2 * chord), tracer.b);
    }
    // A pane of real glass besides: two crossings at normal incidence, 0.96 each.
    scene.place(at(new Box(v(-5, 5, -5), v(5, 6, 5)), glass(1.5)));
    double expected = 0.8 * 0.96 * 0.96 * StrictMath.exp(-0.6);
    assertClose(expected, trace(scene, DEEP, v(0, 0.5, 0), v(0, -1, 0)).r);
    scene.place(at(new Sphere(v(0, 9, 0), 0.5), Material.WHITE));
    assertEquals(0, trace(scene, DEEP, v(0, 0.5, 0), v(0, -1, 0)).r);
  }

  @Test
  void filtersMultiplyWhereverTheyStand() {
    Scene.Builder scene =
        field()
            .background(Background.BLACK)
            .light(new Light.Point(v(0, 9, 0), Rgb.WHITE, false))
            .place(at(new Plane(Vector3d.ZERO, v(0, 1, 0)), Material.WHITE))
            .place(at(new Sphere(v(0, 3, 0), 1), filter(0.5, Medium.VACUUM)))
            .place(at(new Sphere(v(0, 4, 0), 1), filter(0.7, Medium.VACUUM)));
    assertClose(0.25 * 0.49, trace(scene, DEEP, v(0, 0.5, 0), v(0, -1, 0)).r);
  }

  @Test
  void aGlassOnATableHasNoGap() {
    Scene.Builder table =
        field()
            .place(at(new Box(v(-1, 0, -1), v(1, 2, 1)), glass(1.5)))
            .place(at(new Plane(Vector3d.ZERO, v(0, 1, 0)), glowing(0.5)));
    Scene.Builder swapped =
        field()
            .place(at(new Plane(Vector3d.ZERO, v(0, 1, 0)), glowing(0.5)))
            .place(at(new Box(v(-1, 0, -1), v(1, 2, 1)), glass(1.5)));
    double r = 0.04;
    for (Scene.Builder scene : new Scene.Builder[] {table, swapped}) {
      double seen = trace(scene, DEEP, v(0.2, 9, 0.1), v(0, -1, 0)).r;
      assertClose(r + (1 - r) * 0.5, seen);
    }
  }

  @Test
  void aBallLensFocusesWhereParaxialOpticsSays() {
    double n = 1.5;
    Scene.Builder lens = field().place(at(new Sphere(Vector3d.ZERO, 1), glass(n)));
    Recorder recorder = new Recorder();
    Tracer tracer = new Tracer(Prepared.of(lens.build()), 2, 0x1p-40, recorder);
    double b = 1e-4;
    Ray ray = new Ray();
    ray.set(b, 0, 50, 0, 0, -1);
    tracer.trace(ray, Double.POSITIVE_INFINITY);
    RayTree inside = recorder.tree().children().get(0);
    RayTree out = inside.children().get(0);
    assertEquals(RayTree.Kind.REFRACTION, out.kind());
    Vector3d o = out.origin();
    Vector3d d = out.direction();
    double focus = -(o.z() - d.z() / d.x() * o.x());
    assertEquals(n / (2 * (n - 1)), focus, 1e-6);
  }
}
