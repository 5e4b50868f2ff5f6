package glint.render;

import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Box;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.Arrays;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Shadows smaller than a pixel, and light between shadows. A wall is seen from the front, in pixels
 * of length 1; what casts the shadows is behind the eye.
 */
class SmallShadowsTest {

  private static final int SIDE = 60;
  private static final double BEHIND = 50;

  /** Light falls on the wall from the left and the front, or from a point far away there. */
  private enum From {
    AFAR(new Light.Directional(new Vector3d(1, 0, -1), Rgb.WHITE)),
    POINT(new Light.Point(new Vector3d(-1e7, SIDE / 2.0, 1e7), Rgb.WHITE, false));

    final Light light;

    From(Light light) {
      this.light = light;
    }
  }

  /** Radiance of the wall where it is lit. */
  private static final double LIT = Math.sqrt(0.5);

  /** A ball's shadow is an ellipse, as wide as high times the root of 2. */
  @Test
  void specksOfShadowAreFound() {
    for (From from : From.values()) {
      Random random = new Random(11);
      double[] truth = new double[SIDE * SIDE];
      Arrays.fill(truth, LIT);
      Scene.Builder scene = scene(from);
      for (int i = 0; i < 40; i++) {
        double r = 0.02 + 0.25 * random.nextDouble();
        // The shadows of all stay within a pixel, one row each.
        int column = random.nextInt(SIDE);
        int row = i + 10;
        double x = column + 0.5 + (1 - 2.83 * r) * (random.nextDouble() - 0.5);
        double y = SIDE - row - 0.5 + (1 - 2 * r) * (random.nextDouble() - 0.5);
        Vector3d center = new Vector3d(x - BEHIND, y, BEHIND);
        scene.place(Placement.of(new Sphere(center, r), Material.WHITE));
        truth[row * SIDE + column] = LIT * (1 - Math.PI * r * r * Math.sqrt(2));
      }
      double wrong = wrong(scene.build(), truth, 1, 1);
      assertTrue(wrong < 0.1, from + ": " + wrong);
    }
  }

  /** Rows of two boxes leave gaps between their shadows that no corner of a pixel sees. */
  @ParameterizedTest
  @ValueSource(doubles = {0.6, 0.3, 0.1})
  void lightBetweenShadowsIsFound(double width) {
    for (From from : From.values()) {
      double[] truth = new double[SIDE * SIDE];
      Scene.Builder scene = scene(from);
      Random random = new Random(5);
      // Each row of boxes covers the lower half of a row of pixels and the upper half of the next.
      for (int row = -1; row < SIDE; row++) {
        int column = random.nextInt(SIDE);
        double left = column + 0.2;
        box(scene, row, -9, left);
        box(scene, row, left + width, SIDE + 9);
        for (int half = Math.max(0, row); half < Math.min(SIDE, row + 2); half++) {
          truth[half * SIDE + column] += LIT * width / 2;
        }
      }
      double wrong = wrong(scene.build(), truth, 1, 1);
      assertTrue(wrong < 1, from + ": " + wrong);
    }
  }

  /** Adds a flat box whose shadow reaches from one place of a row to another. */
  private static void box(Scene.Builder scene, int row, double from, double to) {
    double top = SIDE - row - 0.5;
    Vector3d least = new Vector3d(from - BEHIND, top - 1, BEHIND);
    Vector3d greatest = new Vector3d(to - BEHIND, top, BEHIND + 1e-9);
    scene.place(Placement.of(new Box(least, greatest), Material.WHITE));
  }

  private static Scene.Builder scene(From from) {
    Vector3d middle = new Vector3d(SIDE / 2.0, SIDE / 2.0, 0);
    return new Scene.Builder("wall")
        .size(SIDE, SIDE)
        .camera(
            Camera.of(
                middle.plus(new Vector3d(0, 0, 1)),
                middle,
                new Vector3d(0, 1, 0),
                new Orthographic(SIDE)))
        .background(Background.constant(Rgb.BLACK))
        .light(from.light)
        .place(Placement.of(new Plane(Vector3d.ZERO, new Vector3d(0, 0, 1)), Material.WHITE));
  }

  /** Renders, and returns how far the image is from the truth, in levels. */
  private static double wrong(Scene scene, double[] truth, double target, long seed) {
    Goal goal = new Goal.Error(target);
    RenderSettings settings =
        new RenderSettings(SIDE, SIDE, goal, seed, OptionalInt.empty(), 2, 32, Set.of());
    double[] rgb = new Renderer(Prepared.of(scene), settings).render(Progress.NONE).image().rgb();
    double sum = 0;
    for (int pixel = 0; pixel < truth.length; pixel++) {
      double off = Transfer.SRGB.level(rgb[3 * pixel]) - Transfer.SRGB.level(truth[pixel]);
      sum += off * off;
    }
    return Math.sqrt(sum / truth.length);
  }
}
