package glint.scenes;

import static java.lang.StrictMath.asin;
import static java.lang.StrictMath.cos;
import static java.lang.StrictMath.exp;
import static java.lang.StrictMath.pow;
import static java.lang.StrictMath.sin;
import static java.lang.StrictMath.sqrt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.io.SceneFile;
import glint.io.SceneFiles;
import glint.verify.Verdict;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.util.List;
import java.util.Locale;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;

/**
 * The formulas of scenes/analytic with other numbers, as scene files that carry their answers: what
 * one ray sees is right to a relative 1e-12.
 */
class AnalyticVariantsTest {

  private static final int TRIES = 60;
  private static final String FINE = "relative: 1e-12";

  /** Renders a scene of one pixel and demands its value. */
  private static void check(String scene, double expected, String how) {
    String text =
        "materials: {plain: {color: 1}}\nscenes:\n  s:\n    image: {width: 1, height: 1}\n"
            + scene.replaceAll("(?m)^", "    ")
            + "\n    expect: [{pixel: [0, 0], value: "
            + expected
            + ", "
            + how
            + "}]\n";
    SceneFile file = read(text);
    assertEquals(List.of(), file.problems(), text);
    Verdict verdict = Verdict.of(file.scenes().get(0), 1).get(0);
    assertTrue(verdict.passed(), () -> verdict + "\n" + text);
  }

  private static SceneFile read(String text) {
    ByteArrayInputStream bytes = new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8));
    try {
      return SceneFiles.read(
          bytes,
          "variant.yaml",
          path -> {
            throw new NoSuchFileException(path);
          });
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static String format(String text, Object... numbers) {
    return String.format(Locale.ROOT, text, numbers);
  }

  /** A ray from (x, y, z) along -z. */
  private static String ray(double x, double y, double z) {
    return format(
        "camera: {position: [%s, %s, %s], look_at: [%s, %s, 0], orthographic: 1}\n", x, y, z, x, y);
  }

  private static String surface(String what) {
    return "surfaces:\n  - " + what;
  }

  private static double fresnel(double cos, double n) {
    double inside = sqrt(1 - (1 - cos) * (1 + cos) / (n * n));
    double across = (cos - n * inside) / (cos + n * inside);
    double along = (n * cos - inside) / (n * cos + inside);
    return (across * across + along * along) / 2;
  }

  @Property(tries = TRIES)
  void lambertsBall(
      @ForAll @DoubleRange(min = 0, max = 3) double phase,
      @ForAll @DoubleRange(min = 0.1, max = 3) double r,
      @ForAll @DoubleRange(min = -0.7, max = 0.7) double x,
      @ForAll @DoubleRange(min = -0.7, max = 0.7) double y) {
    double expected = x * sin(phase) + sqrt(1 - x * x - y * y) * cos(phase);
    Assume.that(Math.abs(expected) > 0.01);
    String light = "lights: [{directional: {direction: [%s, 0, %s], color: 1}}]\n";
    String scene =
        ray(r * x, r * y, r + 3)
            + format(light, -sin(phase), -cos(phase))
            + surface(format("sphere: {center: [0, 0, 0], radius: %s}", r));
    check(scene, Math.max(0, expected), FINE);
  }

  @Property(tries = TRIES)
  void theShadowOfABallInParallelLight(
      @ForAll @DoubleRange(min = 0, max = 1.3) double theta,
      @ForAll @DoubleRange(min = 0.1, max = 2) double r,
      @ForAll @DoubleRange(min = 0, max = 2) double share,
      @ForAll @DoubleRange(min = 0, max = 6.28) double around,
      @ForAll @DoubleRange(min = 0, max = 2) double sigma) {
    // The ball's middle is 4 above the floor; the shadow's middle is 4 tan θ aside.
    double b = share * r;
    double x = 4 * sin(theta) / cos(theta) + b * cos(around) / cos(theta);
    double z = b * sin(around);
    String scene =
        format(
                "camera: {position: [%s, 1, %s], look_at: [%s, 0, %s], up: [0, 0, -1], fov: 1}\n",
                x, z, x, z)
            + format(
                "lights: [{directional: {direction: [%s, %s, 0], color: 1}}]\n",
                sin(theta), -cos(theta))
            + surface("plane: {point: [0, 0, 0], normal: [0, 1, 0]}\n  - ")
            + format("sphere: {center: [0, 4, 0], radius: %s, material: ", r);
    boolean touched = share < 1;
    Assume.that(Math.abs(share - 1) > 1e-9);
    check(scene + "plain}", touched ? 0 : cos(theta), FINE);
    Assume.that(Math.abs(share - 1) > 1e-3);
    double chord = touched ? 2 * sqrt((r - b) * (r + b)) : 0;
    String smoke = format("{transparency: 1, absorption: %s}}", sigma);
    check(scene + smoke, cos(theta) * exp(-sigma * chord), FINE);
  }

  @Property(tries = TRIES)
  void aPointLightOverAPlane(
      @ForAll @DoubleRange(min = 0.1, max = 9) double h,
      @ForAll @DoubleRange(min = -9, max = 9) double x,
      @ForAll @DoubleRange(min = -9, max = 9) double z,
      @ForAll boolean falloff) {
    double d2 = h * h + x * x + z * z;
    String scene =
        format(
                "camera: {position: [%s, 20, %s], look_at: [%s, 0, %s], up: [0, 0, -1], fov: 1}\n",
                x, z, x, z)
            + format(
                "lights: [{point: {position: [0, %s, 0], color: 2, falloff: %s}}]\n",
                h, falloff ? "inverse-square" : "none")
            + surface("plane: {point: [0, 0, 0], normal: [0, 1, 0]}");
    check(scene, 2 * h / sqrt(d2) / (falloff ? d2 : 1), FINE);
  }

  @Property(tries = TRIES)
  void twoMirrors(
      @ForAll @DoubleRange(min = 0.01, max = 0.99) double k,
      @ForAll @DoubleRange(min = 0.01, max = 5) double e,
      @ForAll @DoubleRange(min = 0.5, max = 20) double apart,
      @ForAll @IntRange(min = 0, max = 100) int depth) {
    String mirror = format(", material: {reflection: %s, emission: %s}}", k, e);
    String scene =
        ray(0.3, 0.2, 0.4)
            + surface("plane: {point: [0, 0, 0], normal: [0, 0, 1]" + mirror)
            + format("\n  - plane: {point: [0, 0, %s], normal: [0, 0, 1]", apart)
            + mirror;
    check(scene, e * (1 - pow(k, depth + 1)) / (1 - k), FINE + ", depth: " + depth);
    // As many bounces as matter, if 64 are enough.
    if (k < 0.6) {
      check(scene, e / (1 - k), FINE);
    }
  }

  @Property(tries = TRIES)
  void aMirrorBall(
      @ForAll @DoubleRange(min = 0.1, max = 4) double r,
      @ForAll @DoubleRange(min = -0.7, max = 0.7) double x,
      @ForAll @DoubleRange(min = -0.7, max = 0.7) double y) {
    String scene =
        ray(r * x, r * y, r + 3)
            + "background: {down: 0.5, up: 2}\n"
            + surface(
                format("sphere: {center: [0, 0, 0], radius: %s, material: {reflection: 1}}", r));
    double dy = 2 * y * sqrt(1 - x * x - y * y);
    check(scene, 0.5 + 1.5 * (1 + dy) / 2, FINE);
  }

  @Property(tries = TRIES)
  void highlights(
      @ForAll @DoubleRange(min = 0.1, max = 4) double r,
      @ForAll @DoubleRange(min = 0, max = 0.65) double b,
      @ForAll @DoubleRange(min = 0, max = 60) double exponent,
      @ForAll boolean whole,
      @ForAll boolean phong) {
    double n = whole ? Math.rint(exponent) : exponent;
    String scene =
        ray(r * b * 0.6, r * b * 0.8, r + 3)
            + "lights: [{directional: {direction: [0, 0, -1], color: 1}}]\n"
            + (phong ? "highlights: phong\n" : "")
            + surface(format("sphere: {center: [0, 0, 0], radius: %s, material: ", r))
            + format("{diffuse: 0, specular: 0.5, shininess: %s}}", n);
    double expected = phong ? pow(1 - 2 * b * b, n) : pow(1 - b * b, n / 2);
    Assume.that(expected > 1e-9);
    check(scene, expected / 2, FINE);
  }

  @Property(tries = TRIES)
  void aGlassBallInAField(
      @ForAll @DoubleRange(min = 1.05, max = 2.5) double n,
      @ForAll @DoubleRange(min = 0.2, max = 3) double radius,
      @ForAll @DoubleRange(min = 0, max = 0.95) double b,
      @ForAll @IntRange(min = 1, max = 12) int depth) {
    String scene =
        ray(0, b * radius, radius + 4)
            + "background: 3\n"
            + surface(format("sphere: {center: [0, 0, 0], radius: %s, ", radius))
            + format("material: {transparency: 1, ior: %s}}", n);
    double r = fresnel(sqrt((1 - b) * (1 + b)), n);
    check(scene, 3, FINE);
    double expected = depth == 1 ? r : 1 - (1 - r) * pow(r, depth - 1);
    check(scene, 3 * expected, FINE + ", depth: " + depth);
  }

  private static String slab(int kind, double t, String material) {
    double h = t / 2;
    String dielectric = ", material: {transparency: 1, " + material + "}}";
    String up = "quad: {corner: [-100, %s, -100], edge1: [0, 0, 200], edge2: [200, 0, 0]";
    String down = "quad: {corner: [-100, %s, -100], edge1: [200, 0, 0], edge2: [0, 0, 200]";
    return switch (kind) {
      case 0 -> format("box: {min: [-100, %s, -100], max: [100, %s, 100]", -h, h) + dielectric;
      case 1 -> format(up, h) + dielectric + "\n  - " + format(down, -h) + dielectric;
      case 2 ->
          format("plane: {point: [0, %s, 0], normal: [0, 1, 0]", h)
              + dielectric
              + format("\n  - plane: {point: [0, %s, 0], normal: [0, 1, 0]", -h)
              + ", material: {transparency: 1, priority: 1}}";
      default ->
          // Of two touching boxes of one medium nothing is seen between them.
          format("box: {min: [-100, %s, -100], max: [100, %s, 100]", -h, -h + t / 4)
              + dielectric
              + format("\n  - box: {min: [-100, %s, -100], max: [100, %s, 100]", -h + t / 4, h)
              + dielectric;
    };
  }

  @Property(tries = 2 * TRIES)
  void aSlab(
      @ForAll @DoubleRange(min = 1.05, max = 2.5) double n,
      @ForAll @DoubleRange(min = 0, max = 1.4) double theta,
      @ForAll @DoubleRange(min = 0.5, max = 3) double t,
      @ForAll @DoubleRange(min = 0, max = 2) double sigma,
      @ForAll @IntRange(min = 0, max = 3) int kind) {
    double sin = sin(theta);
    double cos = cos(theta);
    double inside = sqrt(1 - sin * sin / (n * n));
    double r = fresnel(cos, n);
    double tau = exp(-sigma * t / inside);
    double thin = 1 - r * r * tau * tau;
    double front = (1 + cos) / 2;
    double behind = (1 - cos) / 2;
    double expected =
        front * (r + (1 - r) * (1 - r) * r * tau * tau / thin)
            + behind * (1 - r) * (1 - r) * tau / thin;
    // A ray starts up to 2e-13 off a face this wide, and that much of the way is not counted.
    Assume.that(expected > 0.01);
    String scene =
        format(
                "camera: {position: [%s, %s, 0.1], look_at: [0, 0, 0.1], up: [0, 0, -1],"
                    + " orthographic: 1}\n",
                -12 * sin, 12 * cos)
            + "background: {down: 0, up: 1}\n"
            + surface(slab(kind, t, format("ior: %s, absorption: %s", n, sigma)));
    check(scene, expected, FINE + ", depth: 400");
  }

  @Property(tries = TRIES)
  void aSlabMovesWhatIsBehindIt(
      @ForAll @DoubleRange(min = 1.05, max = 2.5) double n,
      @ForAll @DoubleRange(min = 0.1, max = 1.2) double theta,
      @ForAll @DoubleRange(min = 0.1, max = 2) double t,
      @ForAll @IntRange(min = 0, max = 3) int kind,
      @ForAll boolean before) {
    double sin = sin(theta);
    double cos = cos(theta);
    double shift = t * sin * (1 - cos / sqrt(n * n - sin * sin));
    double off = before ? -1e-10 : 1e-10;
    // The ray would meet the floor at y = -5 at z = shift/cos; the slab brings it to z = 0, and
    // off.
    double aside = shift / cos + off;
    String scene =
        format(
                "camera: {position: [0, %s, %s], look_at: [0, -5, %s], orthographic: 1e-13}\n",
                9 * cos - 5, aside - 9 * sin, aside)
            + "lights: [{ambient: {color: 1}}]\n"
            + surface(slab(kind, t, "ior: " + n))
            + "\n  - plane: {point: [0, -5, 0], normal: [0, 1, 0], material: "
            + "{texture: {stripes: {size: 9, colors: [1, 0.5]}}}}";
    Assume.that(9 * cos - 5 > t || 9 * cos - 5 < -5);
    double r = fresnel(cos, n);
    check(scene, (1 - r) * (1 - r) * (before ? 0.5 : 1), FINE + ", depth: 2");
  }

  @Property(tries = TRIES)
  void aBallOfSmoke(
      @ForAll @DoubleRange(min = 0, max = 3) double sigma,
      @ForAll @DoubleRange(min = 0.1, max = 3) double r,
      @ForAll @DoubleRange(min = 0, max = 0.99) double b) {
    String scene =
        ray(0, b * r, r + 4)
            + "background: 1\n"
            + surface(format("sphere: {center: [0, 0, 0], radius: %s, ", r))
            + format("material: {transparency: 1, absorption: %s}}", sigma);
    check(scene, exp(-2 * sigma * r * sqrt((1 - b) * (1 + b))), FINE);
  }

  @Property(tries = TRIES)
  void aGlassFloor(
      @ForAll @DoubleRange(min = 1.05, max = 2.5) double n,
      @ForAll @DoubleRange(min = 0, max = 1.57) double theta) {
    String scene =
        format(
                "camera: {position: [%s, %s, 0], look_at: [0, 0, 0], up: [0, 0, -1],"
                    + " orthographic: 1}\n",
                -4 * sin(theta), 4 * cos(theta))
            + "background: 1\n"
            + surface("plane: {point: [0, 0, 0], normal: [0, 1, 0], ")
            + format("material: {transparency: 1, ior: %s, absorption: 1}}", n);
    check(scene, fresnel(cos(theta), n), FINE);
  }

  @Property(tries = TRIES)
  void aBallLensFocuses(
      @ForAll @DoubleRange(min = 1.2, max = 1.9) double n,
      @ForAll @DoubleRange(min = 0.2, max = 3) double radius,
      @ForAll @DoubleRange(min = 0.01, max = 0.6) double b,
      @ForAll boolean beyond) {
    double turn = 2 * (asin(b) - asin(b / n));
    double crossing = radius * b / sin(turn);
    Assume.that(crossing > radius * 1.001); // not within the ball
    String scene =
        ray(0, b * radius, radius + 4)
            + "lights: [{ambient: {color: 1}}]\n"
            + surface(format("sphere: {center: [0, 0, 0], radius: %s, ", radius))
            + format("material: {transparency: 1, ior: %s}}\n", n)
            + format(
                "  - plane: {point: [0, 0, %s], normal: [0, 0, 1], ",
                -crossing * (beyond ? 1 + 1e-9 : 1 - 1e-9))
            + "material: {texture: {stripes: {size: 9, colors: [1, 0.5]}}}}";
    double r = fresnel(sqrt((1 - b) * (1 + b)), n);
    check(scene, (1 - r) * (1 - r) * (beyond ? 0.5 : 1), FINE + ", depth: 2");
  }

  @Property(tries = TRIES)
  void stripesAcrossTheView(
      @ForAll @DoubleRange(min = 0.1, max = 5) double h,
      @ForAll @DoubleRange(min = 0.1, max = 3) double size,
      @ForAll @DoubleRange(min = 0.1, max = 90) double z) {
    double places = z / size;
    Assume.that(Math.abs(places - Math.rint(places)) > 1e-9);
    String scene =
        format("camera: {position: [0, %s, 0], look_at: [0, 0, %s], fov: 1e-9}\n", h, z)
            + "lights: [{ambient: {color: 1}}]\n"
            + surface("plane: {point: [0, 0, 0], normal: [0, 1, 0], material: ")
            + format("{texture: {stripes: {size: %s, colors: [0.25, 1]}}}}", size);
    check(scene, Math.floor(places) % 2 == 0 ? 0.25 : 1, FINE);
  }

  @Property(tries = 20)
  void aHalfPlane(
      @ForAll @DoubleRange(min = 0, max = 6.28) double alpha,
      @ForAll @DoubleRange(min = -0.8, max = 0.8) double s) {
    double c = cos(alpha);
    double d = sin(alpha);
    String scene =
        ray(0, 0, 5)
            + "lights: [{ambient: {color: 1}}]\n"
            + surface(
                format(
                    "quad: {corner: [%s, %s, 0], edge1: [%s, %s, 0], edge2: [%s, %s, 0]}",
                    s * c + 50 * d, s * d - 50 * c, -50 * c, -50 * d, -100 * d, 100 * c));
    double a = Math.max(Math.abs(c), Math.abs(d));
    double b = Math.min(Math.abs(c), Math.abs(d));
    double to = Math.abs(s);
    double least = (a - b) / 2;
    double most = (a + b) / 2;
    double beyond =
        to <= least ? 0.5 - to / a : to < most ? (most - to) * (most - to) / (2 * a * b) : 0;
    // 4096 samples, one in each of 64 by 64 cells, of which a line crosses 127.
    check(scene, s < 0 ? beyond : 1 - beyond, "tolerance: 0.031, samples: 4096");
  }
}
