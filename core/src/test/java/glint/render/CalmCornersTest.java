package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.light.Light;
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
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** In plain places corners are filled in, but nothing small that lies between is lost. */
class CalmCornersTest {

  private static final int WIDTH = 480;
  private static final int HEIGHT = 360;

  /** Pixels from one small thing to the next. */
  private static final int APART = 20;

  private static final double AROUND = 0.3;

  /** A disc so wide, in pixels, always covers a corner. */
  private static final double COVERS = Math.sqrt(2);

  /** What a small thing is. */
  private enum Kind {
    SPHERE,
    BOX,
    QUAD,
    TUBE,
    MESH;

    /** A thing in the view along -z, so wide and high. */
    Surface of(Vector3d p, double w) {
      Vector3d half = new Vector3d(w / 2, w / 2, 0);
      Vector3d x = new Vector3d(w, 0, 0);
      Vector3d y = new Vector3d(0, w, 0);
      Vector3d a = p.minus(half);
      return switch (this) {
        case SPHERE -> new Sphere(p, w / 2);
        case BOX -> new Box(a, a.plus(new Vector3d(w, w, 1)));
        case QUAD -> new Quad(a, x, y);
        case TUBE ->
            new Cylinder(a.plus(y.times(0.5)), a.plus(x).plus(y.times(0.5)), w / 2, w / 2, false);
        case MESH -> {
          Vector3d b = a.plus(x);
          Vector3d c = b.plus(y);
          double[] places = {a.x(), a.y(), 0, b.x(), b.y(), 0, c.x(), c.y(), 0, a.x(), c.y(), 0};
          yield new Mesh(places, new int[] {0, 1, 2, 0, 2, 3});
        }
      };
    }

    double area(double w) {
      return this == SPHERE ? Math.PI * w * w / 4 : w * w;
    }
  }

  /** Where small things are, and how wide. */
  private record Speck(double x, double y, double width) {

    static List<Speck> some(long seed, double least) {
      Random random = new Random(seed);
      List<Speck> all = new ArrayList<>();
      for (int y = APART; y < HEIGHT - APART / 2; y += APART) {
        for (int x = APART; x < WIDTH - APART / 2; x += APART) {
          double width = least + (2.8 - least) * random.nextDouble();
          all.add(new Speck(x + 4 * random.nextDouble(), y + 4 * random.nextDouble(), width));
        }
      }
      return all;
    }

    /** How much more light there is around than would be, in pixels, in a view along -z. */
    double found(RenderResult result) {
      double sum = 0;
      for (int row = -6; row <= 6; row++) {
        for (int column = -6; column <= 6; column++) {
          int at = (HEIGHT - 1 - (int) y + row) * WIDTH + (int) x + column;
          sum += result.image().rgb()[3 * at] - AROUND;
        }
      }
      return sum;
    }
  }

  @Test
  void smallThingsBeforeAWallAreSeen() {
    for (Kind kind : Kind.values()) {
      Scene.Builder scene = view();
      List<Speck> specks = Speck.some(kind.ordinal(), 0.5);
      for (Speck each : specks) {
        Surface small = kind.of(new Vector3d(each.x, each.y, 0), each.width);
        scene.place(Placement.of(small, glowing(1)));
      }
      RenderResult result = render(scene.build(), 1);
      for (Speck each : specks) {
        double is = (1 - AROUND) * kind.area(each.width);
        assertEquals(is, each.found(result), 0.6 * is, kind + ": " + each);
      }
    }
  }

  @Test
  void smallThingsInAMirrorAreSeen() {
    Material mirror = new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.WHITE, Rgb.BLACK);
    Scene.Builder scene = view();
    Vector3d normal = new Vector3d(1, 0, 1); // what is seen at x is at the depth -x
    scene.place(Placement.of(new Plane(Vector3d.ZERO, normal), mirror));
    List<Speck> specks = Speck.some(5, COVERS);
    for (Speck each : specks) {
      Sphere small = new Sphere(new Vector3d(500, each.y, -each.x), each.width / 2);
      scene.place(Placement.of(small, glowing(1)));
    }
    assertTrue(filledIn(scene.build(), 1) > 0.3, () -> "only " + filledIn(scene.build(), 1));
    RenderResult result = render(scene.build(), 1);
    for (Speck each : specks) {
      double is = (1 - AROUND) * Kind.SPHERE.area(each.width);
      assertEquals(is, each.found(result), 0.6 * is, each.toString());
    }
  }

  /** Balls so high that their shadows fall beside what is seen of them. */
  @Test
  void smallShadowsAreSeen() {
    Material white = new Material(Rgb.WHITE, Rgb.WHITE, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK);
    Material likeFloor = glowing(AROUND);
    Rgb light = Rgb.grey(AROUND * Math.sqrt(2));
    Scene.Builder scene =
        view()
            .light(new Light.Directional(new Vector3d(1, 0, -1), light))
            .place(Placement.of(new Plane(Vector3d.ZERO, new Vector3d(0, 0, 1)), white));
    List<Speck> specks = Speck.some(6, COVERS);
    for (int i = 0; i < specks.size(); i++) {
      Speck each = specks.get(i);
      double w = each.width / 2;
      Vector3d at = new Vector3d(each.x - 70, each.y, 70);
      scene.place(Placement.of(new Sphere(at, w), likeFloor));
    }
    RenderResult result = render(scene.build(), 1);
    for (Speck each : specks) {
      double is = -AROUND * Kind.SPHERE.area(each.width) * Math.sqrt(2);
      assertEquals(is, each.found(result), 0.6 * -is, each.toString());
    }
  }

  @Test
  void aPlainSceneTakesFewRaysAndIsAsGood() {
    Scene scene = lit(0);
    RenderResult result = render(scene, 1);
    Statistics s = result.statistics();
    assertEquals(0, s.minSamples());
    assertTrue(s.rays().camera < 0.6 * WIDTH * HEIGHT, () -> s.toString());
    assertTrue(difference(result, truth(scene)) < 0.05, () -> "off by " + s);
  }

  /** Beside lamps close to a wall light bends by more than what is accepted, but slowly. */
  @Test
  void dullWallsAreFilledInThoughLightBends() {
    Material dull = new Material(Rgb.WHITE, Rgb.grey(0.9), Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK);
    Scene.Builder scene =
        view().place(Placement.of(new Plane(Vector3d.ZERO, new Vector3d(0, 0, 1)), dull));
    for (int i = 0; i < 12; i++) {
      Vector3d place = new Vector3d(60 + 120 * (i % 4), 60 + 120 * (i / 4), 30);
      scene.light(new Light.Point(place, Rgb.grey(0.3), false));
    }
    double share = filledIn(scene.build(), 0.25);
    assertTrue(share > 0.7, () -> "only " + share);
    double off = difference(render(scene.build(), 0.25), truth(scene.build()));
    assertTrue(off < 0.01, () -> "off by " + off);
  }

  /** A highlight a few pixels wide, which four corners so far apart would not tell of. */
  @Test
  void whereLevelsBendAllCornersAreTraced() {
    Material shiny =
        new Material(Rgb.WHITE, Rgb.grey(0.3), Rgb.grey(0.5), 12000, Rgb.BLACK, Rgb.BLACK);
    Scene scene =
        room()
            .light(new Light.Point(new Vector3d(2, 2, -2), Rgb.grey(0.9), false))
            .place(Placement.of(new Plane(Vector3d.ZERO, new Vector3d(0, 1, 0)), shiny))
            .build();
    RenderResult truth = truth(scene);
    assertTrue(brightest(truth) > 0.5, () -> "in sight: " + brightest(truth));
    assertTrue(filledIn(scene, 4) > 0.6, () -> "only " + filledIn(scene, 4));
    double off = difference(render(scene, 4), truth);
    assertTrue(off < 0.3, () -> "off by " + off);
  }

  private static double brightest(RenderResult result) {
    return Arrays.stream(result.image().rgb()).max().orElseThrow();
  }

  /** Returns the share of the pixels that took no ray. */
  private static double filledIn(Scene scene, double target) {
    RenderSettings settings =
        new RenderSettings(
            WIDTH,
            HEIGHT,
            new Goal.Error(target),
            1,
            OptionalInt.empty(),
            2,
            32,
            Set.of(Aov.SAMPLES));
    RenderResult result = new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
    double[] samples = result.aovs().get(Aov.SAMPLES).rgb();
    int without = 0;
    for (double each : samples) {
      without += each == 0 ? 1 : 0;
    }
    return (double) without / samples.length;
  }

  @Test
  void mirroredRoomsAreTheSameByAnyThreadsAndTiles() {
    Scene scene = lit(0.3);
    String one = render(scene, 1, 1, 32).image().sha256();
    assertEquals(one, render(scene, 1, 3, 7).image().sha256());
    assertEquals(one, render(scene, 1, 2, 64).image().sha256());
  }

  /** A ball on a floor in the light of a lamp close by. */
  private static Scene lit(double mirror) {
    Material floor =
        new Material(Rgb.WHITE, Rgb.grey(0.7), Rgb.BLACK, 1, Rgb.grey(mirror), Rgb.BLACK);
    return room()
        .light(new Light.Point(new Vector3d(2, 4, 3), Rgb.grey(0.9), false))
        .place(Placement.of(new Plane(Vector3d.ZERO, new Vector3d(0, 1, 0)), floor))
        .place(Placement.of(new Sphere(new Vector3d(0, 0.7, 0), 0.7), floor))
        .build();
  }

  private static Scene.Builder room() {
    return new Scene.Builder("room")
        .size(WIDTH, HEIGHT)
        .camera(
            Camera.of(
                new Vector3d(0, 3, 8),
                new Vector3d(0, 0.5, 0),
                new Vector3d(0, 1, 0),
                Projection.vertical(40)));
  }

  private static RenderResult truth(Scene scene) {
    RenderSettings settings = settings(new Goal.Samples(64), 2, 32);
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }

  /** The root of the mean square of the difference of all pixels beside no edge. */
  private static double difference(RenderResult a, RenderResult b) {
    double sum = 0;
    int count = 0;
    for (int i = 0; i < 3 * WIDTH * (HEIGHT * 2 / 5); i++) { // the foreground has no edges
      int at = a.image().rgb().length - 1 - i;
      double one = Transfer.SRGB.level(a.image().rgb()[at]);
      double two = Transfer.SRGB.level(b.image().rgb()[at]);
      sum += (one - two) * (one - two);
      count++;
    }
    return Math.sqrt(sum / count);
  }

  /** A view along -z in which a pixel is a unit wide, x to the right and y up from its corner. */
  private static Scene.Builder view() {
    Vector3d middle = new Vector3d(WIDTH / 2.0, HEIGHT / 2.0, 0);
    return new Scene.Builder("specks")
        .size(WIDTH, HEIGHT)
        .transfer(Transfer.LINEAR)
        .background(Background.constant(Rgb.grey(AROUND)))
        .camera(
            Camera.of(
                middle.plus(new Vector3d(0, 0, 1000)),
                middle,
                new Vector3d(0, 1, 0),
                new Orthographic(HEIGHT)));
  }

  private static Material glowing(double radiance) {
    return new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.grey(radiance));
  }

  private static RenderResult render(Scene scene, double target) {
    return render(scene, target, 2, 32);
  }

  private static RenderResult render(Scene scene, double target, int threads, int tile) {
    RenderSettings settings = settings(new Goal.Error(target), threads, tile);
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }

  private static RenderSettings settings(Goal goal, int threads, int tile) {
    return new RenderSettings(WIDTH, HEIGHT, goal, 1, OptionalInt.empty(), threads, tile, Set.of());
  }
}
