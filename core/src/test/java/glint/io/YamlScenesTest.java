package glint.io;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Pyramid;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.light.Light;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Checker;
import glint.optics.Highlight;
import glint.optics.ImageTexture;
import glint.optics.Layout;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Planar;
import glint.optics.Spherical;
import glint.optics.Stripes;
import glint.optics.Wrap;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Expectation;
import glint.scene.Lens;
import glint.scene.Orthographic;
import glint.scene.Perspective;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import glint.scene.Turntable;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class YamlScenesTest {

  private static final Vector3d O = Vector3d.ZERO;
  private static final Vector3d X = new Vector3d(1, 0, 0);
  private static final Vector3d Y = new Vector3d(0, 1, 0);

  private final List<Scene> scenes = everything();

  private static List<Scene> everything() {
    SceneFile file = Resources.read(Resources.text("everything.yaml"), "everything.yaml");
    assertEquals(List.of(), file.problems());
    assertEquals(List.of(), file.notes());
    return file.scenes();
  }

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  @Test
  void whatHasNoEffectIsNotedWhereItStands() {
    String text =
        "materials:\n"
            + "  forgotten: {diffuse: 1, ior: 1.5, absorption: 2}\n"
            + "  off: {transparency: 0, ior: 1.5}\n"
            + "scenes:\n"
            + "  s:\n"
            + "    camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}\n"
            + "    surfaces:\n"
            + "      - sphere: {center: [0, 0, 0], radius: 1, material: forgotten}\n"
            + "      - sphere: {center: [0, 0, 0], radius: 1, material: {priority: 1}}\n";
    SceneFile file = Resources.read(text, "f.yaml");
    assertEquals(List.of(), file.problems());
    assertEquals(1, file.scenes().size());
    assertEquals(
        List.of(
            "f.yaml:2:32: 'ior' has no effect without 'transparency'",
            "f.yaml:2:49: 'absorption' has no effect without 'transparency'",
            "f.yaml:9:69: 'priority' has no effect without 'transparency'"),
        file.notes().stream().map(Problem::toString).collect(Collectors.toList()));
  }

  @Test
  void manyNotesDoNotEndTheReading() {
    StringBuilder text = new StringBuilder("materials:\n");
    for (int i = 0; i < 20_000; i++) {
      text.append("  m").append(i).append(": {ior: 2}\n");
    }
    text.append("scenes:\n  s: {camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}}\n");
    SceneFile file = Resources.read(text.toString(), "f.yaml");
    assertEquals(1, file.scenes().size());
    assertEquals(101, file.notes().size());
  }

  @Test
  void scenesComeInFileOrder() {
    assertEquals(
        List.of("lights and materials", "surfaces", "transforms", "orthographic"),
        scenes.stream().map(Scene::name).collect(Collectors.toList()));
  }

  @Test
  void sceneHasItsOwnSettings() {
    Scene scene = scenes.get(0);
    assertEquals("Lights: six kinds", scene.title());
    assertEquals("64x48", scene.width() + "x" + scene.height());
    Projection projection = new Perspective(40.5, false, 0);
    assertEquals(Camera.of(v(1, 2, 3), v(4, 5, 6), v(0, 0, 2), projection), scene.camera());
    double grey = Transfer.SRGB.decode(128 / 255.0);
    assertEquals(Background.constant(Rgb.grey(grey)), scene.background());
    assertEquals(Highlight.PHONG, scene.highlight());
    assertEquals(Transfer.LINEAR, scene.transfer());
    assertEquals(OptionalInt.empty(), scene.maxDepth());
  }

  @Test
  void sceneTakesTheDefaults() {
    Scene scene = scenes.get(1);
    assertEquals("surfaces", scene.title());
    assertEquals("320x200", scene.width() + "x" + scene.height());
    assertEquals(
        new Camera(
            v(0, 1, 8),
            v(0, 1, 0),
            Y,
            new Perspective(60, true, 0),
            0.5,
            100,
            Optional.of(new Lens(0.25, 8))),
        scene.camera());
    assertEquals(new Background(Rgb.grey(0.25), new Rgb(0, 0, 1)), scene.background());
    assertEquals(List.of(new Light.Ambient(Rgb.grey(0.125))), scene.lights());
    assertEquals(Highlight.BLINN, scene.highlight());
    assertEquals(Transfer.SRGB, scene.transfer());
  }

  @Test
  void ownCameraReplacesTheDefaultOneWhole() {
    Perspective wide = new Perspective(30, false, 1.5);
    assertEquals(Camera.of(v(0, 0, 9), O, Y, wide), scenes.get(2).camera());
  }

  @Test
  void surfacesMayMove() {
    assertEquals(v(0, 0.5, 2), scenes.get(1).placements().get(3).motion());
    assertEquals(O, scenes.get(1).placements().get(2).motion());
  }

  @Test
  void aCameraMayBeOrthographic() {
    assertEquals(
        new Camera(v(0, 0, 9), O, Y, new Orthographic(12.5), 0, 20, Optional.of(new Lens(0, 3))),
        scenes.get(3).camera());
  }

  @Test
  void aTurntable() {
    assertEquals(
        Optional.of(new Turntable(8, v(0, 2, 0), -180, Optional.of(v(0, 0, 3)))),
        scenes.get(3).turntable());
    String text =
        "scenes: {a: {camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}, turntable:"
            + " {frames: 2}}}";
    assertEquals(
        Optional.of(new Turntable(2, Y, 360, Optional.empty())),
        Resources.read(text, "f.yaml").scenes().get(0).turntable());
  }

  @Test
  void expectations() {
    Rgb value = new Rgb(0, 0.5, 2);
    assertEquals(
        List.of(
            new Expectation(
                Optional.of(new Expectation.Pixel(319, 199)),
                value,
                0.25,
                0,
                1,
                OptionalInt.empty()),
            new Expectation(
                Optional.of(new Expectation.Pixel(0, 0)),
                Rgb.WHITE,
                0,
                1e-12,
                64,
                OptionalInt.of(0)),
            new Expectation(Optional.empty(), value, 0.25, 0.125, 16, OptionalInt.empty())),
        scenes.get(3).expectations());
    Expectation last = scenes.get(3).expectations().get(2);
    assertEquals(0.25, last.allowed(0.5));
    assertEquals(0.5, last.allowed(4));
  }

  @Test
  void smallestSceneIsComplete() {
    SceneFile file =
        Resources.read(
            "scenes: {a: {camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}}}", "f.yml");
    Scene scene = file.scenes().get(0);
    assertEquals("640x480", scene.width() + "x" + scene.height());
    assertEquals(Background.BLACK, scene.background());
    assertTrue(scene.lights().isEmpty() && scene.placements().isEmpty());
  }

  @Test
  void lights() {
    assertEquals(
        List.of(
            new Light.Ambient(new Rgb(1, 0.5, 0.25)),
            new Light.Point(v(5, 8, 5), Rgb.WHITE, false),
            new Light.Point(Y, Rgb.grey(2), true),
            new Light.Directional(v(0, -1, 0), Rgb.grey(0.5)),
            new Light.Spot(v(0, 5, 0), O, Rgb.grey(3), 40, 0),
            new Light.Spot(v(0, 5, 0), X, Rgb.grey(3), 180, 0.5),
            new Light.Sphere(v(0, 5, 0), 0.5, Rgb.grey(4)),
            new Light.Rectangle(v(0, 4, 0), v(0, 0, 2), v(3, 0, 0), new Rgb(5, 4, 3))),
        scenes.get(0).lights());
  }

  @Test
  void materials() {
    Rgb color = new Rgb(0.5, 1, 0.25);
    Rgb black = Rgb.BLACK;
    List<Placement> placements = scenes.get(0).placements();
    // The default: diffuse is 1, and the colour multiplies both terms.
    assertEquals(
        new Material(color.times(0.5), color, black, 32, black, black),
        placements.get(0).material());
    // A mirror is not diffuse unless it says so.
    assertEquals(
        new Material(black, black, black, 32, Rgb.grey(0.75), black), placements.get(1).material());
    assertEquals(
        new Material(Rgb.WHITE, Rgb.WHITE, new Rgb(0, 0, 1), 32, black, black)
            .textured(new Stripes(2, Rgb.WHITE, black)),
        placements.get(2).material());
    // A scene's own material hides the file's.
    assertEquals(
        new Material(black, black, black, 32, black, Rgb.grey(2)), placements.get(3).material());
    assertEquals(
        new Material(Rgb.grey(0.5), Rgb.grey(0.5), black, 32, Rgb.WHITE, black),
        placements.get(4).material());
    // What is transparent is not diffuse unless it says so.
    assertEquals(
        new Material(
            black, black, black, 32, black, black, new Rgb(0, 1, 0), new Medium(1, Rgb.grey(2), 0)),
        placements.get(5).material());
    assertEquals(
        new Material(black, black, black, 32, black, black, Rgb.WHITE, Medium.VACUUM),
        placements.get(6).material());
    assertEquals(
        new Material(
                new Rgb(0.125, 0.25, 0),
                new Rgb(0.5, 0.5, 0),
                Rgb.grey(0.125),
                64,
                new Rgb(0, 0, 0.5),
                Rgb.WHITE,
                new Rgb(0.5, 0, 1),
                new Medium(1.5, new Rgb(0, 0.25, 20), -3))
            .textured(new Checker(0.5, Rgb.grey(0.25), new Rgb(1, 0, 0)))
            .glossy(12.5),
        scenes.get(1).placements().get(0).material());
  }

  private static ImageTexture image(Placement placement) {
    return (ImageTexture) placement.material().texture().orElseThrow();
  }

  @Test
  void images() {
    List<Placement> placements = scenes.get(0).placements();
    ImageTexture crate = image(placements.get(7));
    assertEquals(Layout.ONCE, crate.layout());
    assertEquals(Optional.empty(), crate.mapping());
    ImageTexture wall = image(placements.get(8));
    assertEquals(new Layout(2, -3, 0.5, 0.25, Wrap.MIRROR), wall.layout());
    assertEquals(Optional.of(Planar.of(v(1, 2, 3), v(2, 0, 0), v(1, 0, -4))), wall.mapping());
    ImageTexture globe = image(placements.get(9));
    assertEquals(new Layout(2, 2, 0, 0, Wrap.CLAMP), globe.layout());
    assertEquals(Optional.of(Spherical.around(v(1, 2, 3))), globe.mapping());
    assertEquals(
        Optional.of(Spherical.of(v(1, 2, 3), v(0, 0, 1), v(0, -1, 0))),
        image(placements.get(10)).mapping());
    assertSame(crate.image(), wall.image());
    assertNotSame(crate.image(), globe.image());
  }

  @Test
  void surfaceWithoutAnyMaterialIsWhite() {
    String text =
        """
        scenes:
          a:
            camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}
            surfaces:
              - sphere: {center: [0, 0, 0], radius: 1}
              - sphere: {center: [0, 0, 0], radius: 1, material: {}}
        """;
    for (Placement placement : Resources.read(text, "f.yaml").scenes().get(0).placements()) {
      assertEquals(Material.WHITE, placement.material());
    }
  }

  @Test
  void surfaces() {
    List<Surface> expected =
        List.of(
            new Sphere(Y, 1.5),
            new Triangle(O, X, v(0, 1000, -0.5)),
            new Plane(v(0, -1, 0), v(0, 2, 0)),
            new Quad(O, X, Y),
            new Box(v(-1, -2, -3), v(1, 2, 3)),
            new Pyramid(v(0, 2, 0), List.of(v(-1, 0, -1), v(1, 0, -1), v(1, 0, 1), v(-1, 0, 1))),
            new Cylinder(O, Y, 2, 2, true),
            new Cylinder(O, Y, 2, 0, false),
            new Cylinder(O, Y, 2, 0, true),
            new Cylinder(O, Y, 2, 1, true));
    List<Surface> read =
        scenes.get(1).placements().stream().map(Placement::surface).collect(Collectors.toList());
    assertEquals(expected, read.subList(0, expected.size()));
    assertEquals(2, ((Mesh) read.get(expected.size())).triangles());
    assertEquals(expected.size() + 1, read.size());
    assertTrue(scenes.get(1).placements().stream().allMatch(p -> p.toWorld().isIdentity()));
  }

  @Test
  void transforms() {
    Vector3d p = v(1, 2, 3);
    assertNear(v(2, 4, 6), place(0).point(p));
    assertNear(v(1, 4, -12), place(1).point(p));
    assertNear(v(3, 2, -1), place(2).point(p));
    assertNear(v(-1, 2, -3), place(3).point(p));
    // Scale, rotate, translate, in whatever order they are written: (1,2,3) (2,2,3) (-2,2,3).
    assertNear(v(8, 2, 3), place(4).point(p));
    // In the order of the list: (1,2,3) (11,2,3) (-2,11,3).
    assertNear(v(-4, 11, 3), place(5).point(p));
    // About x: (1,-3,2), then about y.
    assertNear(v(2, -3, -1), place(6).point(p));
    // z to x, y to -z, so x to -y.
    assertNear(v(3, -1, -2), place(7).point(p));
    assertNear(v(18, 19, 23), place(8).point(p));
  }

  private Transform place(int i) {
    return scenes.get(2).placements().get(i).toWorld();
  }

  /** A quarter turn by sine and cosine is exact to a few roundings of numbers up to 32. */
  private static void assertNear(Vector3d expected, Vector3d actual) {
    double[] a = {expected.x(), expected.y(), expected.z()};
    double[] b = {actual.x(), actual.y(), actual.z()};
    assertArrayEquals(a, b, 1e-14);
  }

  @Test
  void hexadecimalColoursAreDecoded() {
    for (String[] pair : new String[][] {{"#bc8076", "#BC8076"}, {"#f0a", "#ff00aa"}}) {
      assertEquals(background(pair[1]), background(pair[0]));
    }
    // The codes of linear 0.5, 0.25 and 0.18 decode to within half a code of them.
    Rgb color = background("#bc8976").down();
    assertEquals(0.5, color.r(), 0.003);
    assertEquals(0.25, color.g(), 0.003);
    assertEquals(0.18, color.b(), 0.002);
  }

  private static Background background(String hex) {
    String camera = "camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}";
    String text = "scenes: {a: {" + camera + ", background: '" + hex + "'}}";
    return Resources.read(text, "f.yaml").scenes().get(0).background();
  }

  @Test
  void aliasesStandForWhatTheyName() {
    String text =
        """
        scenes:
          a: &a
            camera: {position: &here [0, 0, 5], look_at: [0, 0, 0], fov: &n 40}
            image: {width: *n, height: 80.0}
            lights: [point: {position: *here, color: 1}]
          b: *a
        """;
    List<Scene> read = Resources.read(text, "f.yaml").scenes();
    assertEquals(List.of(new Light.Point(v(0, 0, 5), Rgb.WHITE, false)), read.get(1).lights());
    assertEquals(40, read.get(1).width());
    assertEquals(80, read.get(1).height());
  }

  @Test
  void namesMayLookLikeNumbersAndHoldLettersOfAllScripts() {
    String camera = "{camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}}";
    String text = "scenes: {007: " + camera + ", true: " + camera + ", Würfel-2_б: " + camera + "}";
    assertEquals(
        List.of("007", "true", "Würfel-2_б"),
        Resources.read(text, "f.yaml").scenes().stream()
            .map(Scene::name)
            .collect(Collectors.toList()));
  }
}
