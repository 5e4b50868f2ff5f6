package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is thinner or smaller than a pixel is found, and its error known. */
class SmallThingsTest {

  private static final int WIDTH = 120;
  private static final int HEIGHT = 90;

  /** What a line is made of; it runs from a to b, its width is square to that in the image. */
  private enum Made {
    QUAD,
    BOX,
    CYLINDER,
    MESH;

    Surface of(Vector3d a, Vector3d b, double w) {
      Vector3d along = b.minus(a);
      Vector3d across = new Vector3d(-along.y(), along.x(), 0).normalized().times(w);
      if (this == CYLINDER) {
        Vector3d half = across.times(0.5);
        return new Cylinder(a.plus(half), b.plus(half), w / 2, w / 2, true);
      }
      if (this == BOX) {
        return new Box(a, a.plus(new Vector3d(along.x(), w, -1)).plus(new Vector3d(0, 0, 2)));
      }
      if (this == QUAD) {
        return new Quad(a, along, across);
      }
      Vector3d c = a.plus(across);
      Vector3d d = b.plus(across);
      double[] p = {a.x(), a.y(), 0, b.x(), b.y(), 0, d.x(), d.y(), 0, c.x(), c.y(), 0};
      return new Mesh(p, new int[] {0, 1, 2, 0, 2, 3});
    }
  }

  /** The share of the pixels crossed by a line none of whose rays has met it. */
  @ParameterizedTest
  @CsvSource({"0.05, 0.1", "0.2, 0.02", "0.5, 0.001"})
  void fewPixelsMissALineThatCrossesThem(double width, double accepted) {
    for (Made made : Made.values()) {
      int crossed = 0;
      int missed = 0;
      double wrong = 0;
      double claimed = 0;
      Random random = new Random(7);
      for (int i = 0; i < 12; i++) {
        double turn = made == Made.BOX ? 0 : random.nextDouble() * Math.PI;
        double length = 20 + 30 * random.nextDouble();
        Vector3d a = new Vector3d(40 * random.nextDouble() + 40, 45 * random.nextDouble(), 0);
        Vector3d b = a.plus(new Vector3d(Math.cos(turn), Math.sin(turn), 0).times(length));
        Scene scene = view(new Orthographic(HEIGHT), List.of(made.of(a, b, width)));
        double[] truth = coverage(a, b, width);
        RenderResult result = render(scene, 1, i);
        claimed += square(result.statistics().samplingError());
        double sum = 0;
        for (int pixel = 0; pixel < truth.length; pixel++) {
          double found = result.image().rgb()[3 * pixel];
          crossed += truth[pixel] > 1e-5 ? 1 : 0;
          missed += truth[pixel] > 1e-5 && found == 0 ? 1 : 0;
          sum += square(Transfer.SRGB.level(found) - Transfer.SRGB.level(truth[pixel]));
        }
        wrong += sum / truth.length;
      }
      double share = (double) missed / crossed;
      assertTrue(share <= accepted, made + ": " + missed + " of " + crossed);
      assertTrue(wrong <= claimed + 1e-4 * 12, made + ": " + wrong + " but claimed " + claimed);
    }
  }

  /** The coverage of pixels by a line, row by row. */
  private static double[] coverage(Vector3d a, Vector3d b, double width) {
    Vector3d along = b.minus(a);
    Vector3d across = new Vector3d(-along.y(), along.x(), 0).normalized().times(width);
    ConvexPolygon line = new ConvexPolygon();
    for (Vector3d p : List.of(a, b, a.plus(across), b.plus(across))) {
      line.add(p.x(), HEIGHT - p.y());
    }
    line.close();
    double[] coverage = new double[WIDTH * HEIGHT];
    ConvexPolygon part = new ConvexPolygon();
    for (int pixel = 0; pixel < coverage.length; pixel++) {
      int x = pixel % WIDTH;
      int y = pixel / WIDTH;
      part.clip(line, x, y, x + 1, y + 1);
      coverage[pixel] = part.area();
    }
    return coverage;
  }

  /** One radiance a thousandth of a pixel wide is worth as much as a plain pixel of its mean. */
  @Test
  void aTinyBrightThingIsSeenInFull() {
    double r = 0.02;
    Material bright = glowing(200);
    Scene scene =
        scene(new Orthographic(HEIGHT))
            .place(Placement.of(new Sphere(new Vector3d(33.4, 71.7, 0), r), bright))
            .build();
    RenderResult result = render(scene, 0.02, 1);
    int pixel = (HEIGHT - 72) * WIDTH + 33;
    assertEquals(200 * Math.PI * r * r, result.image().rgb()[3 * pixel], 0.01);
  }

  /** What stands behind something else is not seen, and makes no pixel worth a second look. */
  @Test
  void hiddenThingsCostAFewLooks() {
    List<Surface> surfaces = new ArrayList<>();
    surfaces.add(
        new Quad(new Vector3d(-1, -1, 5), new Vector3d(200, 0, 0), new Vector3d(0, 200, 0)));
    Random random = new Random(3);
    for (int i = 0; i < 50; i++) {
      surfaces.add(
          new Sphere(new Vector3d(WIDTH * random.nextDouble(), 90 * random.nextDouble(), 0), 0.1));
    }
    RenderResult result = render(view(new Orthographic(HEIGHT), surfaces), 1, 1);
    assertEquals(0, result.statistics().samplingError(), 0.01);
    assertTrue(result.statistics().rays().camera < 1.2 * WIDTH * HEIGHT);
  }

  /** A wire that begins behind the eye and runs past it. */
  @Test
  void aWireThatPassesTheEyeIsFollowed() {
    Cylinder wire =
        new Cylinder(new Vector3d(60.3, 44, 150), new Vector3d(61.7, 47, -2000), 0.01, 0.01, true);
    Scene scene = view(Projection.vertical(50), List.of(wire));
    RenderResult result = render(scene, 0.25, 1);
    RenderResult truth =
        new Renderer(Prepared.of(scene), settings(new Goal.Samples(1024), 5)).render(Progress.NONE);
    int lit = 0;
    for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
      double is = truth.image().rgb()[3 * pixel];
      lit += is > 0 ? 1 : 0;
      assertTrue(is < 0.01 || result.image().rgb()[3 * pixel] > 0, "missed " + pixel);
    }
    assertTrue(lit > 20, "crossed " + lit);
  }

  private static Scene.Builder scene(Projection projection) {
    return new Scene.Builder("small")
        .size(WIDTH, HEIGHT)
        .camera(
            Camera.of(
                new Vector3d(WIDTH / 2.0, HEIGHT / 2.0, 100),
                new Vector3d(WIDTH / 2.0, HEIGHT / 2.0, 0),
                new Vector3d(0, 1, 0),
                projection))
        .background(Background.constant(Rgb.BLACK));
  }

  private static Material glowing(double radiance) {
    return new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.grey(radiance));
  }

  private static Scene view(Projection projection, List<Surface> surfaces) {
    Material white = glowing(1);
    Scene.Builder builder = scene(projection);
    surfaces.forEach(each -> builder.place(Placement.of(each, white)));
    return builder.build();
  }

  private static RenderSettings settings(Goal goal, long seed) {
    return new RenderSettings(WIDTH, HEIGHT, goal, seed, OptionalInt.empty(), 2, 32, Set.of());
  }

  private static RenderResult render(Scene scene, double target, long seed) {
    RenderSettings settings = settings(new Goal.Error(target), seed);
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }

  private static double square(double v) {
    return v * v;
  }
}
