package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Plane;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Stripes;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

/** Renders to an error that is accepted. */
class TargetRenderTest {

  private static final int SIZE = 24;

  @Test
  void aPlainImageTakesOneRayAPixelAndIsClaimedToBeAlmostExact() {
    int size = 4 * SIZE; // enough for audits to tell that hardly anything is hidden
    Scene scene = view(size).background(Background.constant(Rgb.grey(0.3))).build();
    RenderSettings settings =
        new RenderSettings(size, size, new Goal.Error(1), 0, OptionalInt.empty(), 2, 8, Set.of());
    RenderResult result = new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
    Statistics s = result.statistics();
    assertEquals(0, s.samplingError(), 0.01);
    assertEquals(1, s.minSamples());
    assertEquals(0.3, result.image().rgb()[0], 1e-15);
    assertTrue(s.meanSamples() < 1.2, () -> s.toString());
  }

  @Test
  void threadsAndTilesDoNotChangeABit() {
    Scene scene = new RendererTest.World(1, false).scene().build();
    String one = render(scene, 0.5, 3, 1, 7).image().sha256();
    assertEquals(one, render(scene, 0.5, 3, 5, 32).image().sha256());
    assertEquals(one, render(scene, 0.5, 3, 2, 1).image().sha256());
  }

  /** Straight edges in every direction: the coverage of every pixel has a closed form. */
  @Test
  void halfPlanesAreAsExactAsClaimed() {
    int within = 0;
    for (double target : new double[] {2, 1, 0.5, 0.25}) {
      Random random = new Random(42);
      List<Double> ratios = new ArrayList<>();
      for (int i = 0; i < 60; i++) {
        double angle = random.nextDouble() * 2 * Math.PI;
        double distance = SIZE * (random.nextDouble() - 0.5);
        RenderResult result = render(halfPlane(angle, distance), target, i, 2, 8);
        double truth = halfPlaneError(result, angle, distance);
        within += truth <= target ? 1 : 0;
        ratios.add(truth / result.statistics().samplingError());
      }
      ratios.sort(null);
      double median = ratios.get(30);
      double stated = target;
      assertTrue(median > 0.3 && median < 1, () -> "true over claimed " + median + " at " + stated);
    }
    assertTrue(within >= 0.95 * 240, "only " + within + " of 240 as exact as was asked for");
  }

  @Test
  void aBallThatFillsAFewPixelsHasTheAreaOfItsDisc() {
    double radius = 3.3;
    Scene scene =
        view(SIZE)
            .place(Placement.of(new Sphere(new Vector3d(0.31, -0.17, 0), radius), glowing()))
            .build();
    RenderResult result = render(scene, 0.25, 0, 2, 8);
    double sum = 0;
    for (double value : result.image().rgb()) {
      sum += value / 3;
    }
    assertEquals(Math.PI * radius * radius, sum, 0.05);
  }

  @Test
  void anErrorOfAPixelIsClaimedWhereTheEdgeIs() {
    RenderSettings settings =
        new RenderSettings(
            SIZE,
            SIZE,
            new Goal.Error(2),
            0,
            OptionalInt.empty(),
            2,
            8,
            Set.of(Aov.ERROR, Aov.SAMPLES));
    RenderResult result =
        new Renderer(Prepared.of(halfPlane(0.4, 0.3)), settings).render(Progress.NONE);
    double[] errors = result.aovs().get(Aov.ERROR).rgb();
    double[] samples = result.aovs().get(Aov.SAMPLES).rgb();
    assertTrue(errors[3 * (12 * SIZE + 12)] > 1, "at the edge");
    assertTrue(errors[0] < 0.5, "far from it");
    double sum = 0;
    double rays = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
      sum += errors[3 * i] * errors[3 * i];
      rays += samples[3 * i];
    }
    Statistics s = result.statistics();
    double together = Math.sqrt(sum / (SIZE * SIZE));
    assertTrue(s.samplingError() >= together, "the image's claim has a margin for bad luck");
    assertTrue(s.samplingError() < 1.5 * together, () -> s.samplingError() + " for " + together);
    assertEquals(s.meanSamples(), rays / (SIZE * SIZE), 1e-9);
  }

  /** Of the pixels that an edge crosses, as many are within twice their own estimates as should. */
  @Test
  void mostPixelsAreWithinTwiceTheirOwnEstimates() {
    Random random = new Random(7);
    int crossed = 0;
    int within = 0;
    for (int i = 0; i < 60; i++) {
      double angle = random.nextDouble() * 2 * Math.PI;
      double distance = SIZE * (random.nextDouble() - 0.5);
      RenderSettings settings =
          new RenderSettings(
              SIZE, SIZE, new Goal.Error(1), i, OptionalInt.empty(), 2, 8, Set.of(Aov.ERROR));
      RenderResult result =
          new Renderer(Prepared.of(halfPlane(angle, distance)), settings).render(Progress.NONE);
      double[] claims = result.aovs().get(Aov.ERROR).rgb();
      for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
        double truth = coverage(pixel, angle, distance);
        if (truth > 1e-9 && truth < 1 - 1e-9) {
          double error = 255 * Math.abs(result.image().rgb()[3 * pixel] - truth);
          crossed++;
          within += error <= 2 * claims[3 * pixel] ? 1 : 0;
        }
      }
    }
    double share = (double) within / crossed;
    assertTrue(share >= 0.95, () -> "only " + share);
  }

  /** Edges that fall between two pixels cross no pixel, but all rays through corners there. */
  @Test
  void edgesJustAlongPixelsAreFoundInFull() {
    for (int quarter = 0; quarter < 4; quarter++) {
      double angle = quarter * Math.PI / 2;
      RenderResult result = render(halfPlane(angle, 3), 2, quarter, 2, 8);
      double sum = 0;
      for (int i = 0; i < SIZE * SIZE; i++) {
        int row = i / SIZE;
        double x = i % SIZE + 0.5 - SIZE / 2.0;
        double y = SIZE / 2.0 - (row + 0.5);
        boolean white = x * Math.cos(angle) + y * Math.sin(angle) < 3;
        double error = 255 * (result.image().rgb()[3 * i] - (white ? 1 : 0));
        sum += error * error;
      }
      double error = Math.sqrt(sum / (SIZE * SIZE));
      assertTrue(error < 0.2, "turned by " + quarter + ": " + error);
    }
  }

  /** Stripes of which the rays through corners see the even ones only, at first. */
  @Test
  void patternsAreNotTakenForWhatCornersSee() {
    Material stripes =
        new Material(Rgb.WHITE, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK)
            .textured(new Stripes(0.5, Rgb.BLACK, Rgb.WHITE));
    Plane wall = new Plane(new Vector3d(0, 0, -1), new Vector3d(0, 0, 1));
    Scene scene =
        view(SIZE).light(new Light.Ambient(Rgb.WHITE)).place(Placement.of(wall, stripes)).build();
    RenderResult result = render(scene, 1, 4, 2, 8);
    double sum = 0;
    for (double v : result.image().rgb()) {
      sum += 255 * 255 * (v - 0.5) * (v - 0.5);
    }
    double error = Math.sqrt(sum / result.image().rgb().length);
    assertTrue(error <= 1, "off by " + error);
    assertTrue(result.statistics().samplingError() >= error / 2);
  }

  /** An edge that bends more than brackets can tell, and little else: the goal is reached. */
  @Test
  void aBentEdgeIsNotSearchedForEver() {
    Scene scene =
        view(SIZE)
            .place(Placement.of(new Sphere(new Vector3d(0.3, 0.2, 0), 2.2), glowing()))
            .build();
    for (double target : new double[] {1, 0.25, 0.06}) {
      Statistics s = render(scene, target, 1, 2, 8).statistics();
      assertTrue(s.samplingError() <= target, () -> target + ": " + s);
      assertTrue(s.rays().camera < 300 * SIZE * SIZE, () -> s.rays().camera + " rays");
    }
  }

  @Test
  void aLimitOfTimeEndsARenderThatHasNoOtherGoal() {
    Scene scene = new RendererTest.World(1, false).scene().build();
    RenderSettings settings =
        new RenderSettings(64, 48, new Goal.Error(0, 0.3), 0, OptionalInt.empty(), 2, 8, Set.of());
    Statistics s = new Renderer(Prepared.of(scene), settings).render(Progress.NONE).statistics();
    assertTrue(s.samplingError() > 0 && s.samplingError() < 255, () -> s.toString());
    assertThrows(IllegalArgumentException.class, () -> new Goal.Error(0));
    assertThrows(IllegalArgumentException.class, () -> new Goal.Error(-1));
  }

  @Test
  void aCancelledRenderEnds() {
    Scene scene = new RendererTest.World(1, false).scene().build();
    RenderSettings settings =
        new RenderSettings(640, 480, new Goal.Error(1e-3), 0, OptionalInt.empty(), 2, 8, Set.of());
    Renderer renderer = new Renderer(Prepared.of(scene), settings);
    Progress stop = (done, total, rays) -> renderer.cancel();
    assertThrows(CancellationException.class, () -> renderer.render(stop));
  }

  private static RenderResult render(Scene scene, double target, long seed, int threads, int tile) {
    RenderSettings settings =
        new RenderSettings(
            SIZE, SIZE, new Goal.Error(target), seed, OptionalInt.empty(), threads, tile, Set.of());
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }

  /** A view along -z in which a pixel is a unit wide. */
  private static Scene.Builder view(int size) {
    return new Scene.Builder("view")
        .size(size, size)
        .transfer(Transfer.LINEAR)
        .camera(
            Camera.of(
                new Vector3d(0, 0, 100),
                Vector3d.ZERO,
                new Vector3d(0, 1, 0),
                new Orthographic(size)));
  }

  private static Material glowing() {
    return new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.WHITE);
  }

  /** White where x cos α + y sin α &lt; s, in pixels from the middle of the image, y up. */
  private static Scene halfPlane(double angle, double distance) {
    Vector3d normal = new Vector3d(Math.cos(angle), Math.sin(angle), 0);
    Vector3d along = new Vector3d(-Math.sin(angle), Math.cos(angle), 0);
    Vector3d corner = normal.times(distance).minus(along.times(1000));
    Quad quad = new Quad(corner, along.times(2000), normal.times(-1000));
    return view(SIZE).place(Placement.of(quad, glowing())).build();
  }

  private static double halfPlaneError(RenderResult result, double angle, double distance) {
    double sum = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
      double error = 255 * (result.image().rgb()[3 * i] - coverage(i, angle, distance));
      sum += error * error;
    }
    return Math.sqrt(sum / (SIZE * SIZE));
  }

  /** Returns the share of a pixel that lies in a half-plane. */
  private static double coverage(int pixel, double angle, double distance) {
    int row = pixel / SIZE;
    double x = pixel % SIZE + 0.5 - SIZE / 2.0;
    double y = SIZE / 2.0 - (row + 0.5);
    return coverage(angle, distance - x * Math.cos(angle) - y * Math.sin(angle));
  }

  /** The share of a unit square on the near side of a line at a distance from its centre. */
  private static double coverage(double angle, double s) {
    double a = Math.max(Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle)));
    double b = Math.min(Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle)));
    if (s < 0) {
      return 1 - coverage(angle, -s);
    }
    double far = (a + b) / 2;
    if (s >= far) {
      return 1;
    }
    return s <= (a - b) / 2 ? 0.5 + s / a : 1 - (far - s) * (far - s) / (2 * a * b);
  }
}
