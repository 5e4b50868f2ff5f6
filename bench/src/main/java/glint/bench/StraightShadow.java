package glint.bench;

import glint.image.Image;
import java.io.IOException;
import java.util.Locale;

/**
 * How far Glint's straight shadow rays are from the truth: the light on a floor below a lossless
 * ball of glass, under a lamp at the zenith.
 *
 * <p>The truth is found by following the light: it falls on the ball at a distance b from the axis,
 * is mirrored outside, or goes in and leaves after any number of chords, always in one plane with
 * the axis. Angles of a position are counted from the zenith.
 */
public final class StraightShadow {

  private static final double IOR = 1.5;
  private static final double[] HEIGHTS = {1.5, 2, 4};
  private static final double[] RINGS = {0, .1, .2, .4, .6, .8, 1, 1.5, 3};

  /** Beams of light, each of the same cross section. */
  private static final int BEAMS = 1_000_000;

  /** Points of the floor at which Glint is asked, from the axis to the last ring. */
  private static final int POINTS = 3000;

  private static final String SCENE =
      """
      scenes:
        ball:
          image: {width: %d, height: 1}
          camera: {position: [1.5, 0.1, 0], look_at: [1.5, 0, 0], up: [0, 0, -1], orthographic: %s}
          lights: [directional: {direction: [0, -1, 0], color: 1}]
          surfaces:
            - sphere: {center: [0, 2, 0], radius: 1, material: {transparency: 1, ior: 1.5}}
            - plane: {point: [0, 0, 0], normal: [0, 1, 0], material: {diffuse: 1}}
      """;

  private StraightShadow() {}

  /** Prints the table; the argument is the commit. */
  public static void main(String[] args) throws IOException {
    System.out.printf("Java %s, commit %s.%n%n", System.getProperty("java.version"), args[0]);
    double[] glint = glint();
    double[][] truth = new double[HEIGHTS.length][];
    for (int i = 0; i < HEIGHTS.length; i++) {
      truth[i] = truth(HEIGHTS[i]);
    }
    StringBuilder head = new StringBuilder("| distance from the axis | Glint |");
    for (double height : HEIGHTS) {
      head.append(String.format(Locale.ROOT, " true, %s |", height));
    }
    System.out.println(head);
    System.out.println("|---|---|" + "---|".repeat(HEIGHTS.length));
    for (int ring = 0; ring + 1 < RINGS.length; ring++) {
      row(RINGS[ring] + " to " + RINGS[ring + 1], ring, ring, glint, truth);
    }
    row("**all below the ball**", 0, ringAt(1) - 1, glint, truth);
    row("**all of these**", 0, RINGS.length - 2, glint, truth);
  }

  private static void row(String name, int first, int last, double[] glint, double[][] truth) {
    double area = 0;
    for (int ring = first; ring <= last; ring++) {
      area += area(ring);
    }
    StringBuilder row = new StringBuilder("| " + name + " |");
    row.append(String.format(Locale.ROOT, " %.3f |", sum(glint, first, last) / area));
    for (double[] each : truth) {
      row.append(String.format(Locale.ROOT, " %.3f |", sum(each, first, last) / area));
    }
    System.out.println(row);
  }

  private static double sum(double[] light, int first, int last) {
    double sum = 0;
    for (int ring = first; ring <= last; ring++) {
      sum += light[ring];
    }
    return sum;
  }

  /** The area of a ring, over π. */
  private static double area(int ring) {
    return RINGS[ring + 1] * RINGS[ring + 1] - RINGS[ring] * RINGS[ring];
  }

  private static int ringAt(double distance) {
    int ring = 0;
    while (ring + 1 < RINGS.length && RINGS[ring + 1] <= distance) {
      ring++;
    }
    return ring;
  }

  /** The light on each ring, over π, as Glint sees it. */
  private static double[] glint() throws IOException {
    double end = RINGS[RINGS.length - 1];
    Image floor = Scenes.render(Scenes.parse(SCENE.formatted(POINTS, end / POINTS))).image();
    double[] light = new double[RINGS.length];
    for (int i = 0; i < POINTS; i++) {
      double inner = end * i / POINTS;
      double outer = end * (i + 1) / POINTS;
      light[ringAt((inner + outer) / 2)] += floor.rgb()[3 * i] * (outer * outer - inner * inner);
    }
    return light;
  }

  /** The light on each ring, over π, that reaches a floor so far below the ball's centre. */
  private static double[] truth(double height) {
    double[] light = new double[RINGS.length];
    for (int i = 0; i < BEAMS; i++) {
      double b = Math.sqrt((i + 0.5) / BEAMS);
      double in = Math.asin(b);
      double inside = Math.asin(b / IOR);
      double reflected = reflectance(in, inside);
      double weight = 1.0 / BEAMS;
      land(light, height, in, 2 * in, weight * reflected);
      weight *= (1 - reflected) * (1 - reflected);
      for (int chords = 1; weight > 1e-20; chords++) {
        double position = in + chords * (Math.PI - 2 * inside);
        land(light, height, position, position + in, weight);
        weight *= reflected;
      }
    }
    // What passes beside the ball
    for (int ring = ringAt(1); ring + 1 < RINGS.length; ring++) {
      light[ring] += area(ring);
    }
    return light;
  }

  /** Lets a beam fall that leaves the ball's surface at one angle in the direction of another. */
  private static void land(
      double[] light, double height, double position, double direction, double weight) {
    if (Math.cos(direction) < 0) {
      double way = (height + Math.cos(position)) / -Math.cos(direction);
      light[ringAt(Math.abs(Math.sin(position) + way * Math.sin(direction)))] += weight;
    }
  }

  /** Fresnel's law by the angles on both sides. */
  private static double reflectance(double in, double inside) {
    double s = Math.sin(in - inside) / Math.sin(in + inside);
    double p = Math.tan(in - inside) / Math.tan(in + inside);
    return (s * s + p * p) / 2;
  }
}
