package glint.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.CornerValues;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Pyramid;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.image.Image;
import glint.image.Noise;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.ImageTexture;
import glint.optics.Layout;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Stripes;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Lens;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.RenderPlan;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What may not change an image does not, and what should stop a render does. */
class RendererTest {

  private static final int WIDTH = 97;
  private static final int HEIGHT = 61;

  /** One of every surface, mirrors and lights, in a world that may be scaled and mirrored. */
  record World(double scale, boolean mirrored) {

    Vector3d v(double x, double y, double z) {
      return new Vector3d(mirrored ? -x * scale : x * scale, y * scale, z * scale);
    }

    Vector3d d(double x, double y, double z) {
      return new Vector3d(mirrored ? -x : x, y, z);
    }

    List<Surface> surfaces() {
      return List.of(
          new Plane(v(0, -1, 0), d(0.1, 1, 0)),
          new Sphere(v(0.3, 0.4, 0), scale * 0.9),
          new Triangle(v(-3, -1, -1), v(-1, 2.5, -1.5), v(-0.5, -1, 0)),
          new Quad(v(1.5, -1, -2), v(2, 0.3, 0), v(0.2, 2, 0.4)),
          box(),
          new Pyramid(
              v(-1, 0.3, 2), List.of(v(-2, -1, 1), v(-0.3, -1, 1), v(0, -1, 2.7), v(-2, -1, 3))),
          new Cylinder(v(1.8, -1, 1), v(2, 0.4, 0.8), scale * 0.4, scale * 0.2, true));
    }

    /** An octahedron that looks round, whose outside may be its inside. */
    private Mesh jewel() {
      Vector3d[] at = {
        v(2.3, 1.4, 1),
        v(1.1, 1.4, 1),
        v(1.7, 2, 1),
        v(1.7, 0.8, 1),
        v(1.7, 1.4, 1.6),
        v(1.7, 1.4, 0.4)
      };
      double[] points = new double[18];
      double[] normals = new double[18];
      Vector3d middle = v(1.7, 1.4, 1);
      for (int i = 0; i < 6; i++) {
        Vector3d n = at[i].minus(middle);
        System.arraycopy(new double[] {at[i].x(), at[i].y(), at[i].z()}, 0, points, 3 * i, 3);
        System.arraycopy(new double[] {n.x(), n.y(), n.z()}, 0, normals, 3 * i, 3);
      }
      int[] corners = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
      Mesh flat = new Mesh(points, corners);
      double[] pairs = {0, 0, 1, 0, 2, 0.5, 0.5, -1};
      int[] paired = new int[24];
      for (int i = 0; i < 24; i++) {
        paired[i] = corners[i] % 5 - 1; // some have none
      }
      return flat.withNormals(new CornerValues(3, normals, corners), new int[8])
          .withTexture(new CornerValues(2, pairs, paired));
    }

    private Box box() {
      return mirrored
          ? new Box(new Vector3d(scale * 2.4, -scale, -scale), v(-4, 0.1, 0.2))
          : new Box(v(-4, -1, -1), v(-2.4, 0.1, 0.2));
    }

    Scene.Builder scene() {
      Material mirror =
          new Material(
                  Rgb.grey(0.1),
                  new Rgb(0.2, 0.3, 0.4),
                  Rgb.grey(0.5),
                  40,
                  Rgb.grey(0.6),
                  Rgb.BLACK)
              .textured(new Stripes(0.3 * scale, Rgb.WHITE, new Rgb(0.2, 0.5, 0.7)))
              .glossy(5000);
      Material picture =
          mirror.textured(new ImageTexture(Noise.of(5, 3), Layout.ONCE, Optional.empty()));
      Scene.Builder scene =
          new Scene.Builder("world")
              .camera(
                  new Camera(
                      v(0.5, 1.5, 8),
                      v(0.1, 0.2, 0.3),
                      d(0, 1, 0),
                      lens(),
                      0,
                      Double.POSITIVE_INFINITY,
                      Optional.of(new Lens(scale / 16, scale * 7))))
              .background(new Background(Rgb.grey(0.1), new Rgb(0.3, 0.4, 0.9)))
              .light(new Light.Ambient(Rgb.grey(0.2)))
              .light(new Light.Point(v(3, 6, 4), Rgb.grey(0.5), false))
              .light(new Light.Point(v(-3, 4, 3), Rgb.grey(9 * scale * scale), true))
              .light(new Light.Directional(d(-0.2, -1, -0.4), Rgb.grey(0.2)))
              .light(new Light.Sphere(v(2.2, 2.8, 2), scale * 0.4, Rgb.grey(2)))
              .light(panel());
      for (Surface surface : surfaces()) {
        boolean pictured = surface instanceof Quad || surface instanceof Triangle;
        Material plain = surface instanceof Box ? Material.WHITE : mirror;
        Vector3d way = surface instanceof Quad ? v(0.1, 0, 0.2) : Vector3d.ZERO;
        scene.place(Placement.of(surface, pictured ? picture : plain).moving(way));
      }
      Transform squash =
          Transform.scale(new Vector3d(1, 0.5, 0.7))
              .then(Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 0, 0), 40)))
              .then(Transform.translate(v(0.5, -0.4, 2.5)));
      scene.place(
          new Placement(new Sphere(Vector3d.ZERO, scale * 0.6), squash, mirror)
              .moving(v(0.2, -0.3, 0)));
      Mesh jewel = jewel();
      scene.place(Placement.of(jewel, picture));
      Transform shrunk =
          Transform.scale(new Vector3d(0.5, -0.7, 0.6))
              .then(Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 0, 0), 25)))
              .then(Transform.translate(v(-2.3, 3, 0.8)));
      scene.place(new Placement(jewel, shrunk, picture));
      scene.place(Placement.of(new Sphere(v(-0.8, -0.2, 3), scale * 0.5), glass(1.5, 1)));
      return scene.place(Placement.of(new Sphere(v(-0.4, -0.4, 3), scale * 0.4), glass(1.3, 0)));
    }

    /** Before the camera's upper edge; its front stays where it is in a mirror. */
    private Light panel() {
      Vector3d across = v(1.2, 0, 0);
      Vector3d deep = v(0, 0, 0.8);
      return new Light.Rectangle(
          v(-1, 3, 2), mirrored ? deep : across, mirrored ? across : deep, new Rgb(3, 2, 1));
    }

    private Material glass(double ior, int priority) {
      Rgb absorption = new Rgb(0.1, 0.5, 0.3).times(1 / scale);
      return new Material(
          Rgb.BLACK,
          Rgb.BLACK,
          Rgb.grey(0.3),
          60,
          Rgb.BLACK,
          Rgb.BLACK,
          Rgb.grey(0.9),
          new Medium(ior, absorption, priority));
    }

    private static Projection lens() {
      return Projection.vertical(50);
    }
  }

  private static RenderSettings settings(int samples, int threads, int tile) {
    return new RenderSettings(
        WIDTH, HEIGHT, samples, 0, OptionalInt.empty(), threads, tile, Set.of());
  }

  private static RenderResult render(Prepared scene, RenderSettings settings) {
    return new Renderer(scene, settings).render(Progress.NONE);
  }

  private static String hash(Scene.Builder scene, RenderSettings settings) {
    return render(Prepared.of(scene.build()), settings).image().sha256();
  }

  @ParameterizedTest
  @CsvSource({"1,7", "2,32", "5,64", "3,1000", "8,1"})
  void neitherThreadsNorTilesChangeABit(int threads, int tile) {
    World world = new World(1, false);
    assertEquals(
        hash(world.scene(), settings(5, 1, 32)), hash(world.scene(), settings(5, threads, tile)));
  }

  @Test
  void powersOfTwoChangeNoBit() {
    String expected = hash(new World(1, false).scene(), settings(4, 2, 32));
    for (int k : new int[] {-40, -17, -1, 1, 13, 40}) {
      World scaled = new World(Math.scalb(1.0, k), false);
      assertEquals(expected, hash(scaled.scene(), settings(4, 2, 32)), "scaled by 2^" + k);
    }
  }

  @Test
  void aMirroredWorldGivesTheMirroredImage() {
    RenderSettings one = settings(1, 2, 32);
    Image image = render(Prepared.of(new World(1, false).scene().build()), one).image();
    Image mirrored = render(Prepared.of(new World(1, true).scene().build()), one).image();
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        for (int c = 0; c < 3; c++) {
          int there = 3 * (y * WIDTH + WIDTH - 1 - x) + c;
          assertEquals(image.rgb()[3 * (y * WIDTH + x) + c], mirrored.rgb()[there]);
        }
      }
    }
  }

  @Test
  void theOrderOfSurfacesChangesNoBit() {
    Scene scene = new World(1, false).scene().build();
    List<Placement> reversed = new ArrayList<>(scene.placements());
    Collections.reverse(reversed);
    Scene.Builder other = new Scene.Builder("reversed").camera(scene.camera());
    other.background(scene.background());
    scene.lights().forEach(other::light);
    reversed.forEach(other::place);
    RenderSettings one = settings(1, 2, 32);
    assertEquals(render(Prepared.of(scene), one).image().sha256(), hash(other, one));
  }

  @Test
  void leavingOutWhatASceneDoesNotNeedChangesNoBit() {
    Camera camera =
        Camera.of(
            new Vector3d(0, 0, 5), Vector3d.ZERO, new Vector3d(0, 1, 0), Projection.vertical(40));
    Scene plain =
        new Scene.Builder("plain")
            .camera(camera)
            .background(Background.constant(new Rgb(0.1, 0.2, 0.3)))
            .light(new Light.Ambient(Rgb.grey(0.5)))
            .place(Placement.of(new Sphere(Vector3d.ZERO, 1), Material.WHITE))
            .build();
    RenderResult lean = render(Prepared.of(plain), settings(4, 2, 32));
    Prepared full = Prepared.of(plain, RenderPlan.everything());
    assertEquals(lean.image().sha256(), render(full, settings(4, 2, 32)).image().sha256());
    assertTrue(Prepared.of(plain).plan().decisions().stream().noneMatch(d -> d.used()));
    assertEquals(0, lean.statistics().rays().shadow);
    assertEquals(0, lean.statistics().rays().reflection);
    assertEquals(0, lean.statistics().rays().highlights);

    Scene rich = new World(1, false).scene().build();
    assertTrue(Prepared.of(rich).plan().decisions().stream().allMatch(d -> d.used()));
    assertTrue(render(Prepared.of(rich), settings(1, 2, 32)).statistics().rays().highlights > 0);
  }

  @Test
  void oneSampleSitsInThePixelsCentre() {
    // A black half-plane ends exactly in the middle of the middle pixel: only the centre is seen.
    Scene.Builder half =
        new Scene.Builder("half")
            .camera(
                Camera.of(
                    new Vector3d(0, 0, 1), Vector3d.ZERO, new Vector3d(0, 1, 0), World.lens()))
            .background(Background.constant(Rgb.WHITE))
            .place(
                Placement.of(
                    new Quad(new Vector3d(0, -9, 0), new Vector3d(9, 0, 0), new Vector3d(0, 18, 0)),
                    Material.WHITE));
    Image one = render(Prepared.of(half.build()), settings(1, 1, 32)).image();
    Image many = render(Prepared.of(half.build()), settings(16, 1, 32)).image();
    int middle = 3 * (30 * WIDTH + 48);
    assertEquals(1, one.rgb()[middle - 3]);
    assertEquals(0, one.rgb()[middle], "an edge through the centre belongs to the surface");
    assertEquals(0.5, many.rgb()[middle], "16 samples of a net split evenly");
  }

  @Test
  void anotherSeedIsAnotherImage() {
    World world = new World(1, false);
    RenderSettings other =
        new RenderSettings(WIDTH, HEIGHT, 4, 1, OptionalInt.empty(), 2, 32, Set.of());
    assertNotEquals(hash(world.scene(), settings(4, 2, 32)), hash(world.scene(), other));
  }

  @Test
  void statisticsCountEveryRay() {
    Scene scene = new World(1, false).scene().build();
    Statistics s = render(Prepared.of(scene), settings(3, 2, 16)).statistics();
    assertEquals(3L * WIDTH * HEIGHT, s.rays().camera);
    assertTrue(s.rays().shadow > s.rays().camera);
    assertTrue(s.rays().reflection > 0);
    assertTrue(s.rays().maxDepth > 1);
    assertEquals(0, s.invalid());
    long[] heard = new long[3];
    new Renderer(Prepared.of(scene), settings(3, 2, 16))
        .render(
            (done, total, rays) -> {
              heard[0] = Math.max(heard[0], done);
              heard[1] = total;
              heard[2] = Math.max(heard[2], rays);
            });
    assertArrayEquals(new long[] {28, 28, s.rays().total()}, heard);
  }

  @Test
  void depthLimitsBounces() {
    Scene scene = new World(1, false).scene().build();
    RenderSettings none =
        new RenderSettings(WIDTH, HEIGHT, 1, 0, OptionalInt.of(0), 1, 32, Set.of());
    Statistics s = render(Prepared.of(scene), none).statistics();
    assertEquals(0, s.rays().reflection);
    assertEquals(0, s.rays().maxDepth);
  }

  @Test
  void theUsersDepthOverrulesTheScenes() {
    Prepared scene = Prepared.of(new World(1, false).scene().maxDepth(0).build());
    RenderSettings own =
        new RenderSettings(WIDTH, HEIGHT, 1, 0, OptionalInt.empty(), 1, 32, Set.of());
    RenderSettings two =
        new RenderSettings(WIDTH, HEIGHT, 1, 0, OptionalInt.of(2), 1, 32, Set.of());
    Statistics stated = render(scene, own).statistics();
    assertEquals(0, stated.rays().reflection);
    assertTrue(stated.truncation() > 0, "the light of mirrors is missing");
    Statistics overruled = render(scene, two).statistics();
    assertEquals(2, overruled.rays().maxDepth);
    assertTrue(overruled.truncation() < stated.truncation());
  }

  @Test
  void cancellingStopsSoonAndSaysSo() {
    Scene scene = new World(1, false).scene().build();
    RenderSettings heavy =
        new RenderSettings(2000, 2000, 10000, 0, OptionalInt.empty(), 2, 64, Set.of());
    Renderer renderer = new Renderer(Prepared.of(scene), heavy);
    Thread canceller =
        new Thread(
            () -> {
              while (renderer.image().rgb()[0] == 0) {
                Thread.onSpinWait();
              }
              renderer.cancel();
            });
    canceller.start();
    assertThrows(CancellationException.class, () -> renderer.render(Progress.NONE));
  }

  @Test
  void aovsTellWhatTheCentreSees() {
    Scene.Builder ball =
        new Scene.Builder("ball")
            .camera(
                Camera.of(
                    new Vector3d(0, 0, 5), Vector3d.ZERO, new Vector3d(0, 1, 0), World.lens()))
            .place(Placement.of(new Sphere(Vector3d.ZERO, 1), Material.WHITE));
    RenderSettings all =
        new RenderSettings(WIDTH, HEIGHT, 1, 0, OptionalInt.empty(), 2, 32, Set.of(Aov.values()));
    RenderResult result = render(Prepared.of(ball.build()), all);
    int middle = 3 * (30 * WIDTH + 48);
    assertEquals(4, result.aovs().get(Aov.DEPTH).rgb()[middle], 1e-12);
    assertEquals(Double.POSITIVE_INFINITY, result.aovs().get(Aov.DEPTH).rgb()[0]);
    assertEquals(1, result.aovs().get(Aov.NORMAL).rgb()[middle + 2], 1e-12);
    assertEquals(1, result.aovs().get(Aov.ALBEDO).rgb()[middle]);
    assertEquals(0, result.aovs().get(Aov.ID).rgb()[middle]);
    assertEquals(-1, result.aovs().get(Aov.ID).rgb()[0]);
  }
}
