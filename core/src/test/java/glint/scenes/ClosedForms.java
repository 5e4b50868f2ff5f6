package glint.scenes;

import static java.lang.StrictMath.asin;
import static java.lang.StrictMath.atan2;
import static java.lang.StrictMath.exp;
import static java.lang.StrictMath.log;
import static java.lang.StrictMath.pow;
import static java.lang.StrictMath.sin;
import static java.lang.StrictMath.sqrt;

import glint.color.Rgb;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;

/**
 * What the scenes of scenes/analytic must show, from the formulas that stand in them: for each
 * scene the values of its expectations, in order.
 */
final class ClosedForms {

  private static final double PI = StrictMath.PI;

  private final Map<String, List<Rgb>> values = new LinkedHashMap<>();

  /** Returns the values by scene. */
  static Map<String, List<Rgb>> all() {
    ClosedForms forms = new ClosedForms();
    forms.background();
    forms.coverage();
    forms.patterns();
    forms.diffuse();
    forms.mirrors();
    forms.highlights();
    forms.absorption();
    forms.balls();
    forms.slabs();
    forms.floors();
    forms.lenses();
    forms.lamps();
    forms.blur();
    forms.gloss();
    forms.motion();
    return forms.values;
  }

  /** Sets the values of a scene: colours, or numbers for greys. */
  private void scene(String name, Object... expected) {
    List<Rgb> colors = new ArrayList<>();
    for (Object each : expected) {
      colors.add(each instanceof Rgb rgb ? rgb : Rgb.grey(((Number) each).doubleValue()));
    }
    values.put(name, colors);
  }

  /** Returns a colour of one formula in three numbers. */
  private static Rgb each(Rgb numbers, DoubleUnaryOperator formula) {
    return new Rgb(
        formula.applyAsDouble(numbers.r()),
        formula.applyAsDouble(numbers.g()),
        formula.applyAsDouble(numbers.b()));
  }

  private static Rgb blend(Rgb down, Rgb up, double t) {
    return down.times(1 - t).plus(up.times(t));
  }

  /** A1: the gradient for a direction through (sx, sy), or along the view. */
  private void background() {
    Rgb plain = new Rgb(0.25, 0.5, 1);
    scene("sky-constant", plain, plain, plain);
    Rgb along = tilted(1.0 / 3);
    scene("sky-gradient", through(-1, 2.0 / 3), through(1, -2.0 / 3), through(-1.0 / 3, 0));
    scene("sky-parallel", along, along);
  }

  private static Rgb through(double sx, double sy) {
    return tilted((1 + sy * sqrt(8)) / 3 / sqrt(1 + sx * sx + sy * sy));
  }

  private static Rgb tilted(double dy) {
    return blend(new Rgb(0.2, 0.1, 0.05), new Rgb(0.1, 0.4, 0.9), (1 + dy) / 2);
  }

  /** A2, A3, A23. */
  private void coverage() {
    scene("edge-upright", covered(1, 0, 0.25));
    scene("edge-steep", covered(0.96, 0.28, 0.2));
    scene("edge-oblique", covered(0.6, 0.8, 0.125));
    scene("edge-corner", covered(0.6, 0.8, 0.5));
    scene("edge-perspective", covered(0.6, 0.8, 0.125));
    scene("pixel-half", covered(1, 0, 0));
    scene("pixel-quarter", 0.25);
    scene("pixel-grey", 0.18);
    scene("ball-ahead", outline(1.0 / 2, 0) / 4);
    scene("ball-aside", outline(1 / 2.5, PI / 6) / 12);
  }

  private static double covered(double cos, double sin, double s) {
    double a = Math.max(Math.abs(cos), Math.abs(sin));
    double b = Math.min(Math.abs(cos), Math.abs(sin));
    double most = (a + b) / 2;
    return s <= (a - b) / 2 ? 0.5 + s / a : 1 - (most - s) * (most - s) / (2 * a * b);
  }

  private static double outline(double sinA, double theta) {
    double cosA = sqrt(1 - sinA * sinA);
    double cos = StrictMath.cos(theta);
    double q = cos * cos - sinA * sinA;
    return PI * (sinA * cosA / q) * (sinA / sqrt(q));
  }

  /** A13, A24. */
  private void patterns() {
    scene("stripes-floor", log(2) / 2);
    double beyond =
        log(2) - (1 - 1 / 2.0 + 1 / 3.0 - 1 / 4.0 + 1 / 5.0 - 1 / 6.0 + 1 / 7.0 - 1 / 8.0);
    double row9 = 1 / 5.0 - 1 / 6.0 + 1 / 7.0 - 1 / 8.0;
    scene("stripes-rows", 1, 8 * (1 / 3.0 - 1 / 4.0), 8 * row9, 8 * beyond, 1, 0, 1, 1);
    Rgb a = new Rgb(0.2, 0.4, 0.6);
    Rgb b = Rgb.WHITE;
    Rgb half = blend(a, b, 0.5);
    scene("checker-ahead", a, b, a, blend(a, b, 0.75), half, half, b);
  }

  /** A4, A5, A6. */
  private void diffuse() {
    scene(
        "phase-near",
        lambert(9, 5, 0.8, 0.6),
        lambert(-1, -1, 0.8, 0.6),
        lambert(-13, -3, 0.8, 0.6),
        disc(atan2(4, 3)) * PI / 4);
    scene(
        "phase-far",
        lambert(13, -1, 0.8, -0.6),
        lambert(-1, 1, 0.8, -0.6),
        disc(atan2(4, -3)) * PI / 4);
    scene("phase-lit-part", (1 + 0.6) / 2 * PI / 4);
    scene("shadow-parallel", 0, 0.8, 0, 0.8, 0.8 * (1 - PI * 0.25 / 0.8 / 4));
    scene("shadow-point", 0, plain(1, 4, 2.31, 0), plain(1, 4, 2.312, 0));
    scene("shadow-point-area", 1 - PI * (16 / (4.0 - 1)) / 64);
    scene(
        "point-falloff",
        falloff(0.125, 0.125),
        falloff(1.625, 0.875),
        0,
        2 * PI * 3 * (1 - 1 / sqrt(5)) / 16);
    scene("point-plain", plain(0.75, 1.5, 0.125, 0.125), plain(0.75, 1.5, 1.625, 0.875));
  }

  /** ρE = 1, at sixteenths of the radius. */
  private static double lambert(double x, double y, double sin, double cos) {
    double z = sqrt(256 - x * x - y * y);
    return Math.max(0, (x * sin + z * cos) / 16);
  }

  private static double disc(double phase) {
    return 2.0 / 3 * (sin(phase) + (PI - phase) * StrictMath.cos(phase)) / PI;
  }

  private static double plain(double intensity, double h, double x, double z) {
    return intensity * h / sqrt(h * h + x * x + z * z);
  }

  private static double falloff(double x, double z) {
    return 3 / pow(1 + x * x + z * z, 1.5);
  }

  /** A7, A16. */
  private void mirrors() {
    scene("mirrors-halving", 0.25, series(0.5, 3) / 4, series(0.5, 20) / 4, 0.5);
    Rgb glow = new Rgb(0.1, 0.2, 0.4);
    scene(
        "mirrors-bright",
        glow.times(series(0.9, 1)),
        glow.times(series(0.9, 64)),
        glow.times(1 / (1 - 0.9)));
    Rgb down = new Rgb(0.1, 0.2, 0.3);
    Rgb up = new Rgb(1, 0.4, 0.3);
    scene(
        "mirror-ball-above",
        blend(down, up, 1 - 1 / 8.0),
        blend(down, up, 1 - 5 / 8.0),
        down,
        blend(down, blend(down, up, 0.5), PI / 4));
    scene("mirror-ball-ahead", mirrored(-0.25, 0.25), mirrored(0.25, 0.75), mirrored(0.75, -0.25));
  }

  private static double series(double k, int bounces) {
    return (1 - pow(k, bounces + 1)) / (1 - k);
  }

  private static double mirrored(double x, double y) {
    return (1 + 2 * y * sqrt(1 - x * x - y * y)) / 2;
  }

  /** A17. */
  private void highlights() {
    scene("highlight-phong", pow(1 - 2 / 8.0, 10), 0, PI / 4 / (2 * 11));
    scene("highlight-phong-broken", pow(0.75, 2.5), PI / 4 / (2 * 3.5));
    scene("highlight-blinn", pow(7 / 8.0, 4.5), pow(3 / 8.0, 4.5), 0, PI / 4 * 2 / 11);
    Rgb both = each(new Rgb(0.5, 0.25, 0), k -> 2 * (sqrt(7 / 8.0) / 8 + k * pow(7 / 8.0, 20)));
    scene("highlight-on-grey", both);
  }

  /** A10, A11. */
  private void absorption() {
    Rgb sigma = new Rgb(0.25, 1, 3);
    scene(
        "smoke-ball",
        each(sigma, s -> exp(-2 * s * sqrt(7 / 8.0))),
        each(sigma, s -> exp(-2 * s * sqrt(3 / 8.0))),
        1,
        each(sigma, s -> 1 - PI / 4 + PI / 4 * throughDisc(2 * s)));
    Rgb out = each(sigma, s -> exp(-s / 2));
    scene("smoke-eye-inside", out, out);
    double b2 = 0.8 * 0.8 / 16 + 1 / 16.0;
    Rgb shade = each(sigma, s -> 0.8 * exp(-2 * s * sqrt(0.25 - b2)));
    double area = PI * 0.25 / 0.8 / 4;
    scene(
        "smoke-shadow",
        shade,
        shade,
        0.8,
        each(sigma, s -> 0.8 * (1 - area + area * throughDisc(s))));
  }

  private static double throughDisc(double x) {
    return 2 * (1 - (1 + x) * exp(-x)) / (x * x);
  }

  /** A8: depth 1 to 6 at b² of eighths. */
  private void balls() {
    scene("ball-lossless", 2, 2, 2, 2 * atBall(1), left(1, 2), left(1, 3), left(5, 2), left(5, 6));
  }

  private static double atBall(double eighths) {
    return fresnel(sqrt(1 - eighths / 8), 1.5);
  }

  private static double left(double eighths, int depth) {
    double r = atBall(eighths);
    return 2 * (1 - (1 - r) * pow(r, depth - 1));
  }

  /** The amplitudes by the sines and cosines of both angles (Born and Wolf, 1.5.2). */
  private static double fresnel(double cos, double n) {
    double inside = sqrt(1 - (1 - cos * cos) / (n * n));
    double across = (cos - n * inside) / (cos + n * inside);
    double along = (n * cos - inside) / (n * cos + inside);
    return (across * across + along * along) / 2;
  }

  /** A9. */
  private void slabs() {
    scene("slab-front", 1 / 13.0);
    scene("slab-behind", 12 / 13.0);
    Rgb down = new Rgb(0.1, 0.5, 1);
    Rgb up = new Rgb(1, 0.25, 0.5);
    Rgb front = blend(down, up, 0.9);
    Rgb behind = blend(down, up, 0.1);
    double r = fresnel(0.8, 1.5);
    double inside = sqrt(1 - 0.36 / 2.25);
    Rgb tau = each(new Rgb(0.2, 0.5, 1), s -> exp(-s / inside));
    Rgb back = each(tau, t -> r + (1 - r) * (1 - r) * r * t * t / (1 - r * r * t * t));
    Rgb on = each(tau, t -> (1 - r) * (1 - r) * t / (1 - r * r * t * t));
    Rgb seen = front.times(back).plus(behind.times(on));
    scene("slab-oblique", seen);
    scene("slab-quads", seen);
    scene("slab-planes", seen);
    scene("slab-shift", (1 - r) * (1 - r), (1 - r) * (1 - r) / 2);
  }

  /** A14. */
  private void floors() {
    scene("fresnel-normal", 0.2 * 0.2);
    scene("fresnel-brewster", pow(1.25 / 3.25, 2) / 2);
    scene("fresnel-rows", 1, row(0.125), row(0.375), row(0.625), row(0.875));
  }

  private static double row(double s) {
    return fresnel(s / sqrt(1 + s * s), 1.33);
  }

  /** A25. */
  private void lenses() {
    double r = fresnel(sqrt(1 - 1e-8), 1.5);
    scene("lens-before-focus", (1 - r) * (1 - r));
    scene("lens-beyond-focus", (1 - r) * (1 - r) / 2);
    scene("lens-aside", lens(0.75), lens(0.25), lens(-0.75));
  }

  private static double lens(double y) {
    double z = sqrt(1 - y * y);
    double r = fresnel(z, 1.5);
    double turn = 2 * (asin(y) - asin(y / 1.5));
    return r * (1 + 2 * y * z) / 2 + (1 - r) * (1 - r) * (1 - sin(turn)) / 2;
  }

  /** A19, A20. */
  private void lamps() {
    Rgb color = new Rgb(1, 2, 4);
    Rgb above = color.times(0.5 * 0.25 * 0.25);
    scene("lamp-ball-above", above, above);
    scene("lamp-ball-aside", 0.5 * 10 * 0.8 / 25, 0.5 * 10 * 0.8 / 25);
    scene("lamp-rectangle-above", color.times(0.5 * formFactor(1, 0.5)));
    scene(
        "lamp-rectangle-aside",
        0.5 * 20 * (formFactor(2, 2) - 2 * formFactor(1, 2) + formFactor(1, 1)));
    scene("lamp-ball-angle", 2 * (1 - 0.8));
    scene("lamp-rectangle-angle", 4.0 / 6);
    scene("lamp-half-hidden", 0.5 * 16 / 16 / 2);
    scene("lamp-part-hidden", 0.5 * 2 * 4 * formFactor(0.25, 0.5));
    scene("lamp-seen", color, new Rgb(3, 2, 1), 0.125, color.times(0.5), 0.125 / 2);
  }

  private static double formFactor(double a, double b) {
    double p = sqrt(1 + a * a);
    double q = sqrt(1 + b * b);
    return (a / p * atan2(b, p) + b / q * atan2(a, q)) / (2 * PI);
  }

  private void blur() {
    scene("lens-near", beyond(0.5));
    scene("lens-far", beyond(0.6));
    scene("lens-parallel", beyond(0.8));
    scene("lens-sharp", 1);
  }

  /** The share of a disc beyond a line. */
  private static double beyond(double s) {
    return (PI / 2 - asin(s) - s * sqrt(1 - s * s)) / PI;
  }

  private void gloss() {
    scene("gloss-white", new Rgb(0.25, 0.5, 0.75));
    scene("gloss-gradient", new Rgb(1, 2, 4).times(0.5 * (1 + 9.0 / 10) / 2));
    scene("gloss-ball", 1 - pow(0.8, 4));
    scene("gloss-square", formFactor(1, 1));
  }

  private void motion() {
    scene("motion-passing", 0.25 / 2);
    scene("motion-coming", 1 / 4.0 + 0.5 * (1 - 1 / 4.0));
    scene("motion-shadow", 0.5 * (1 - 1 / 2.0));
    scene("motion-mirror", 0.5 * (1 - 1 / 2.0));
    scene("motion-stripes", (1 + 0.5) / 2);
  }
}
