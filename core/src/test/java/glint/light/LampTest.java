package glint.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.math.Vector3d;
import glint.sampling.SobolSampler;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What lamps send, held against sums over small parts of their areas. */
class LampTest {

  private static final int SAMPLES = 1 << 14;

  /** Parts of a lamp, in each of two directions. */
  private static final int PARTS = 600;

  private static final SobolSampler NUMBERS = new SobolSampler(7);

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Illumination lamp(Light light) {
    return new Illumination(List.of(light));
  }

  private static Hit at(Vector3d p, Vector3d n) {
    Hit hit = new Hit();
    hit.px = p.x();
    hit.py = p.y();
    hit.pz = p.z();
    Vector3d unit = n.normalized();
    hit.nx = unit.x();
    hit.ny = unit.y();
    hit.nz = unit.z();
    hit.sx = hit.nx;
    hit.sy = hit.ny;
    hit.sz = hit.nz;
    return hit;
  }

  /** Something that depends on the direction of the light in an uneven way, zero below. */
  private static double answer(Hit hit, Vector3d l) {
    double cos = hit.sx * l.x() + hit.sy * l.y() + hit.sz * l.z();
    double other = 0.3 * l.x() - 0.7 * l.y() + 0.5 * l.z();
    return cos > 0 ? cos * (1 + other * other) : 0;
  }

  private static double sampled(Light light, Hit hit, ToDoubleFunction<Vector3d> function) {
    Illumination lights = lamp(light);
    LightSample sample = new LightSample();
    NUMBERS.pixel(3, 4);
    double sum = 0;
    for (int i = 0; i < SAMPLES; i++) {
      NUMBERS.sample(i);
      if (lights.at(0, hit, NUMBERS, 0, sample)) {
        Vector3d l = v(sample.lx, sample.ly, sample.lz);
        assertEquals(1, l.length(), 1e-14);
        sum += sample.r * function.applyAsDouble(l);
      }
    }
    return sum / SAMPLES;
  }

  /** The limit of points of intensity cos θ' dA/π each. */
  private static double summed(
      Light.Rectangle light, Hit hit, ToDoubleFunction<Vector3d> function) {
    Vector3d cross = light.edge1().cross(light.edge2());
    Vector3d front = cross.normalized();
    double sum = 0;
    for (int i = 0; i < PARTS; i++) {
      for (int j = 0; j < PARTS; j++) {
        Vector3d place =
            light
                .corner()
                .plus(light.edge1().times((i + 0.5) / PARTS))
                .plus(light.edge2().times((j + 0.5) / PARTS));
        sum += part(place, front, cross.length() / PARTS / PARTS, hit, function);
      }
    }
    return sum;
  }

  private static double summed(Light.Sphere light, Hit hit, ToDoubleFunction<Vector3d> function) {
    double sum = 0;
    double area = 4 * Math.PI * light.radius() * light.radius() / PARTS / PARTS;
    for (int i = 0; i < PARTS; i++) {
      double z = (2 * i + 1.0) / PARTS - 1;
      double r = Math.sqrt(1 - z * z);
      for (int j = 0; j < PARTS; j++) {
        double phi = 2 * Math.PI * (j + 0.5) / PARTS;
        Vector3d n = v(r * StrictMath.cos(phi), r * StrictMath.sin(phi), z);
        sum += part(light.center().plus(n.times(light.radius())), n, area, hit, function);
      }
    }
    return sum;
  }

  private static double part(
      Vector3d place, Vector3d n, double area, Hit hit, ToDoubleFunction<Vector3d> function) {
    Vector3d way = place.minus(v(hit.px, hit.py, hit.pz));
    Vector3d l = way.normalized();
    return Math.max(0, -n.dot(l)) / (Math.PI * way.dot(way)) * area * function.applyAsDouble(l);
  }

  @ParameterizedTest(name = "from ({0}, {1}, {2}), normal ({3}, {4}, {5})")
  @CsvSource({
    "0, 0, 0, 0, 1, 0", // below the middle
    "3, 0, 1, 0, 1, 0", // aside
    "9, 0, 4, -1, 1, 0", // a little nearer than far
    "12, -8, 4, -1, 1, 0.3", // far
    "0.4, 1.9, 0.6, 0.2, 1, 0", // close, before it
    "4, 1.7, -1, -1, 0.3, 0", // from the side, close to its plane
    "0, 0, 0, 1, 0.2, 0", // across the horizon
    "0, 0, 0, 1, -0.4, 0", // only a corner above the horizon
  })
  void aRectangleSendsWhatItsPartsSend(
      double x, double y, double z, double nx, double ny, double nz) {
    Light.Rectangle light =
        new Light.Rectangle(v(-0.5, 2, -1), v(1.8, 0, 0), v(0, 0, 1.5), Rgb.WHITE);
    Hit hit = at(v(x, y, z), v(nx, ny, nz));
    double expected = summed(light, hit, l -> answer(hit, l));
    double actual = sampled(light, hit, l -> answer(hit, l));
    assertTrue(expected > 0);
    assertEquals(expected, actual, 1e-4 * expected);
  }

  @ParameterizedTest(name = "from ({0}, {1}, {2}), normal ({3}, {4}, {5})")
  @CsvSource({
    "0, 0, 0, 0, 1, 0", // below
    "3, 0, 1, 0, 1, 0", // aside
    "40, 3, -30, -1, 1, 0", // far
    "0.3, 1.2, 0.2, 0, 1, 0", // close
    "0, 0, 0, 1, 0.45, 0", // touches the horizon nearly
    "0, 0, 0, 1, 0.2, 0", // across the horizon
    "0, 0, 0, 1, -0.2, 0", // less than half above
  })
  void aSphereSendsWhatItsPartsSend(double x, double y, double z, double nx, double ny, double nz) {
    Light.Sphere light = new Light.Sphere(v(0.2, 2, 0.1), 0.7, Rgb.WHITE);
    Hit hit = at(v(x, y, z), v(nx, ny, nz));
    double expected = summed(light, hit, l -> answer(hit, l));
    double actual = sampled(light, hit, l -> answer(hit, l));
    assertTrue(expected > 0);
    assertEquals(expected, actual, 4e-4 * expected);
  }

  @Test
  void everySampleOfASphereInFullViewBringsTheSameDiffuseLight() {
    Light.Sphere light = new Light.Sphere(v(0.2, 2, 0.1), 0.7, Rgb.WHITE);
    Hit hit = at(v(1, 0, 0), v(0, 1, 0));
    double d2 = 0.64 + 4 + 0.01;
    double expected = 0.49 / d2 * 2 / Math.sqrt(d2);
    LightSample sample = new LightSample();
    for (int i = 0; i < 100; i++) {
      NUMBERS.sample(i);
      lamp(light).at(0, hit, NUMBERS, 0, sample);
      assertEquals(expected, sample.r * sample.ly, 1e-14 * expected);
    }
  }

  /** The way to the light ends on it, to within rounding, wherever the light is. */
  @ParameterizedTest
  @CsvSource({"1", "1e-6", "1e6"})
  void shadowRaysEndAtTheLamp(double size) {
    Light.Sphere ball = new Light.Sphere(v(0.2, 2, 0.1), 0.7 * Math.min(size, 1), Rgb.WHITE);
    Light.Rectangle panel =
        new Light.Rectangle(
            v(-0.5 * size, 2, -size), v(1.8 * size, 0, 0), v(0, 0, 1.5 * size), Rgb.WHITE);
    LightSample sample = new LightSample();
    Ray ray = new Ray();
    for (int i = 0; i < 1000; i++) {
      Hit hit = at(v(0.01 * i - 5, 0, 0.7), v(0.3, 1, -0.2));
      NUMBERS.sample(i);
      if (lamp(ball).at(0, hit, NUMBERS, 0, sample)) {
        double end = lamp(ball).shadowRay(0, sample, hit, ray);
        Vector3d place = v(ray.ox + end * ray.dx, ray.oy + end * ray.dy, ray.oz + end * ray.dz);
        double from = place.minus(ball.center()).length();
        // The direction is good to a few roundings, of which its distance aside is a part of 6.
        assertEquals(ball.radius(), from, 1e-7 * ball.radius() + 1e-14);
      }
      if (lamp(panel).at(0, hit, NUMBERS, 0, sample)) {
        double end = lamp(panel).shadowRay(0, sample, hit, ray);
        assertEquals(2, ray.oy + end * ray.dy, 1e-14);
        assertInside(-0.5 * size, 1.3 * size, ray.ox + end * ray.dx);
        assertInside(-size, 0.5 * size, ray.oz + end * ray.dz);
      }
    }
  }

  private static void assertInside(double least, double most, double number) {
    double rounding = 1e-14 * (10 + Math.abs(most));
    assertTrue(number >= least - rounding && number <= most + rounding, () -> "" + number);
  }

  @Test
  void lampsSendNothingBackwards() {
    Light.Rectangle panel = new Light.Rectangle(v(-1, 2, -1), v(2, 0, 0), v(0, 0, 2), Rgb.WHITE);
    Light.Sphere ball = new Light.Sphere(v(0, 0, 0), 1, Rgb.WHITE);
    LightSample sample = new LightSample();
    NUMBERS.sample(5);
    assertTrue(lamp(panel).at(0, at(v(0, 1.99, 0), v(0, 1, 0)), NUMBERS, 0, sample));
    assertFalse(lamp(panel).at(0, at(v(0, 2, 0), v(0, 1, 0)), NUMBERS, 0, sample));
    assertFalse(lamp(panel).at(0, at(v(0, 2.01, 0), v(0, -1, 0)), NUMBERS, 0, sample));
    assertFalse(lamp(ball).at(0, at(v(0, 0.99, 0), v(0, 1, 0)), NUMBERS, 0, sample));
    assertTrue(lamp(ball).at(0, at(v(0, 1.01, 0), v(0, -1, 0)), NUMBERS, 0, sample));
  }

  /** A centred sample is the middle, with what the whole lamp brings in full view. */
  @Test
  void theMiddleStandsForAll() {
    Light.Sphere ball = new Light.Sphere(v(0, 2, 0), 0.7, Rgb.WHITE);
    LightSample sample = new LightSample();
    Hit hit = at(v(0, 0, 0), v(0, 1, 0));
    NUMBERS.centre();
    assertTrue(lamp(ball).at(0, hit, NUMBERS, 0, sample));
    assertEquals(v(0, 1, 0), v(sample.lx, sample.ly, sample.lz));
    assertEquals(0.49 / 4, sample.r, 1e-16);
    // A square of edge 2 at distance 1 is a face of a cube: 4π/6.
    Light.Rectangle panel = new Light.Rectangle(v(-1, 1, -1), v(2, 0, 0), v(0, 0, 2), Rgb.WHITE);
    assertTrue(lamp(panel).at(0, hit, NUMBERS, 0, sample));
    assertEquals(v(0, 1, 0), v(sample.lx, sample.ly, sample.lz));
    assertEquals(2.0 / 3, sample.r, 1e-15);
  }
}
