package glint.io;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.light.Light;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Highlight;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.NamedMaterial;
import glint.scene.Perspective;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class Cs315Test {

  private static final String HEAD =
      """
      Camera   1 2 40   0 1 0   0 3 9.9  36.5   1
      Output   512   512   CornellBox.png
      """;

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Scene scene(String body) {
    SceneFile file = Resources.read(HEAD + body, "folder/own name.txt");
    assertEquals(List.of(), file.problems());
    return file.scenes().get(0);
  }

  @Test
  void settings() {
    Scene scene = scene("BounceDepth 3\n");
    assertEquals("CornellBox", scene.name());
    assertEquals("512x512", scene.width() + "x" + scene.height());
    assertEquals(
        Camera.of(v(1, 2, 40), v(0, 3, 9.9), v(0, 1, 0), Projection.vertical(36.5)),
        scene.camera());
    assertEquals(OptionalInt.of(3), scene.maxDepth());
    assertEquals(Highlight.PHONG, scene.highlight());
    assertEquals(Transfer.LINEAR, scene.transfer());
    assertEquals(Background.BLACK, scene.background());
    assertEquals(OptionalInt.empty(), scene("").maxDepth());
  }

  @Test
  void anAspectThatIsNotTheImagesIsKept() {
    String camera = "Camera 0 0 5  0 1 0  0 0 0  40 ";
    for (String output : List.of("Output 512 256 a.png\n", "")) {
      String text = output + camera + "2\n" + (output.isEmpty() ? "Output 512 256 a.png\n" : "");
      Scene wide = Resources.read(text, "a.txt").scenes().get(0);
      assertEquals(new Perspective(40, false, 0), wide.camera().projection());
    }
    Scene narrow = Resources.read(camera + "0.5\nOutput 512 256 a.png\n", "a.txt").scenes().get(0);
    assertEquals(new Perspective(40, false, 0.5), narrow.camera().projection());
  }

  @Test
  void theNameComesFromOutputOrElseFromTheFile() {
    String camera = "Camera 0 0 5  0 1 0  0 0 0  40 1\nOutput 9 9 ";
    for (String[] pair :
        new String[][] {
          {"out/Two.Parts.png", "Two.Parts"},
          {"C:\\out\\One.png", "One"},
          {"None", "None"},
        }) {
      SceneFile file = Resources.read(camera + pair[0], "own.txt");
      assertEquals(pair[1], file.scenes().get(0).name());
      assertEquals(List.of(), file.notes());
    }
    SceneFile hidden = Resources.read(camera + ".png", "some/own.name.txt");
    assertEquals("own.name", hidden.scenes().get(0).name());
    assertEquals(
        "some/own.name.txt:2:12: '' cannot be a scene's name: the scene is called 'own.name'",
        hidden.notes().get(0).toString());
    SceneFile neither = Resources.read(camera + "*.png", ".txt");
    assertEquals(
        List.of(".txt:2:12: '*' cannot be a scene's name"),
        neither.problems().stream().map(Problem::toString).collect(Collectors.toList()));
  }

  @Test
  void materialsHoldUntilTheNext() {
    Scene scene =
        scene(
            """
            Material  .1 .2 .3  .4 .5 .6  .7 .8 .9  1 2 3  40
            Sphere 1 2 3 4
            Triangle 1 2 3  4 5 6  7 8 -9.5e0
            Material  1 1 1  0 0 0  0 0 0  0 0 0  0
            Sphere 0 0 0 1
            """);
    Material first =
        new Material(
            new Rgb(.1, .2, .3),
            new Rgb(.4, .5, .6),
            new Rgb(.7, .8, .9),
            40,
            new Rgb(1, 2, 3),
            Rgb.BLACK);
    Material second = new Material(Rgb.WHITE, Rgb.BLACK, Rgb.BLACK, 0, Rgb.BLACK, Rgb.BLACK);
    assertEquals(
        List.of(
            placed(new Sphere(v(1, 2, 3), 4), first, 4),
            placed(new Triangle(v(1, 2, 3), v(4, 5, 6), v(7, 8, -9.5)), first, 5),
            placed(new Sphere(Vector3d.ZERO, 1), second, 7)),
        scene.placements());
  }

  private static Placement placed(Surface surface, Material material, int line) {
    return new Placement(
        surface, Transform.IDENTITY, List.of(new NamedMaterial("", material)), line);
  }

  @Test
  void lightsAddUpAndFollowTheMatrix() {
    Scene scene =
        scene(
            """
            AmbientLight 0.1 0.2 0.3
            AmbientLight 0.5 0.5 0.5
            Translate 10 0 0
            Scale 2 2 2
            PointLight 1 2 3  1 0 0
            DirectionalLight 1 2 3  0 1 0
            """);
    assertEquals(
        List.of(
            new Light.Ambient(new Rgb(0.1, 0.2, 0.3)),
            new Light.Ambient(Rgb.grey(0.5)),
            new Light.Point(v(12, 4, 6), new Rgb(1, 0, 0), false),
            new Light.Directional(v(2, 4, 6), new Rgb(0, 1, 0))),
        scene.lights());
  }

  /** The matrices of GRAMMAR: top = top M, and Rotate is Rx Ry Rz, by their textbook forms. */
  @Test
  void matricesMultiplyFromTheRight() {
    Scene scene =
        scene(
            """
            Material  1 1 1  0 0 0  0 0 0  0 0 0  0
            Translate 1 2 3
            PushMatrix
            Rotate 30 45 60
            PushMatrix
            Scale 2 3 4
            Sphere 0 0 0 1
            PopMatrix
            Sphere 0 0 0 1
            PopMatrix
            Sphere 0 0 0 1
            PushMatrix
            """);
    double[][] rotation = product(product(rx(30), ry(45)), rz(60));
    double[][] scale = {{2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
    assertMatrix(product(rotation, scale), scene.placements().get(0).toWorld());
    assertMatrix(rotation, scene.placements().get(1).toWorld());
    assertEquals(
        Transform.translate(v(1, 2, 3)).point(v(5, 6, 7)),
        scene.placements().get(2).toWorld().point(v(5, 6, 7)));
  }

  private static void assertMatrix(double[][] m, Transform actual) {
    double[] rows = {
      m[0][0], m[0][1], m[0][2], 1, m[1][0], m[1][1], m[1][2], 2, m[2][0], m[2][1], m[2][2], 3
    };
    // Numbers up to 4, a few dozen roundings each.
    assertArrayEquals(rows, actual.rows(), 1e-14);
  }

  private static double[][] rx(double degrees) {
    double c = Math.cos(Math.toRadians(degrees));
    double s = Math.sin(Math.toRadians(degrees));
    return new double[][] {{1, 0, 0}, {0, c, -s}, {0, s, c}};
  }

  private static double[][] ry(double degrees) {
    double c = Math.cos(Math.toRadians(degrees));
    double s = Math.sin(Math.toRadians(degrees));
    return new double[][] {{c, 0, s}, {0, 1, 0}, {-s, 0, c}};
  }

  private static double[][] rz(double degrees) {
    double c = Math.cos(Math.toRadians(degrees));
    double s = Math.sin(Math.toRadians(degrees));
    return new double[][] {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
  }

  private static double[][] product(double[][] a, double[][] b) {
    double[][] c = new double[3][3];
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        for (int k = 0; k < 3; k++) {
          c[i][j] += a[i][k] * b[k][j];
        }
      }
    }
    return c;
  }

  @Test
  void whiteSpaceAndCommentsAreFree() {
    String body =
        "\r\n# comment\r\n\t Material\t1 1 1  1 1 1\t0 0 0  0 0 0  0 \t\r\n  #Sphere 1\r\n"
            + "Sphere 0 0 0 1 # the only one\r\n\r\n";
    assertEquals(1, scene(body).placements().size());
  }

  @Test
  void whatIsAssumedOrUnusedIsNoted() {
    SceneFile file =
        Resources.read(HEAD + "ShadowBias 1e-4\nSphere 0 0 0 1\nSphere 1 0 0 1\n", "a.txt");
    assertEquals(
        List.of(
            "a.txt:3:1: ShadowBias 1e-4 is not used: Glint needs none",
            "a.txt:4:1: Sphere stands before the first Material: it is plain white"),
        file.notes().stream().map(Problem::toString).collect(Collectors.toList()));
    assertEquals(Material.WHITE, file.scenes().get(0).placements().get(1).material());
  }

  @Test
  void theScenesOfTheRepositoryAreGood() throws IOException {
    for (Path file : Resources.scenes(".txt")) {
      SceneFile read = Resources.read(Files.readAllBytes(file), file.toString());
      assertEquals(List.of(), read.problems());
    }
  }

  /** The scenes of the course itself, where they lie beside the repository. */
  @Test
  void theCourseScenesAreRead() throws IOException {
    Path folder = Resources.repository().resolveSibling("shared").resolve("data/cs148");
    assumeTrue(Files.isDirectory(folder), "skipped: the course's scenes are not here");
    try (Stream<Path> files = Files.list(folder)) {
      List<Path> texts =
          files.filter(file -> file.toString().endsWith(".txt")).collect(Collectors.toList());
      assertTrue(texts.size() >= 5);
      for (Path text : texts) {
        SceneFile file = Resources.read(Files.readAllBytes(text), text.toString());
        assertEquals(List.of(), file.problems());
        assertEquals(1, file.notes().size());
        assertEquals(text.getFileName().toString(), file.scenes().get(0).name() + ".txt");
      }
    }
  }
}
