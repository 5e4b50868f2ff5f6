package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Mesh;
import glint.geometry.MeshFacts;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.NamedMaterial;
import glint.scene.Placement;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Models that scene files name. */
class ModelsTest {

  private static final String CAMERA =
      "    camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}\n    surfaces:\n";

  private final List<String> opened = new ArrayList<>();
  private int closed;

  /** The test's models, under names that tell that they come from here. */
  private final SceneFolder folder =
      new SceneFolder() {
        @Override
        public InputStream open(String path) throws IOException {
          opened.add(path);
          byte[] bytes = Resources.MODELS.open(path).readAllBytes();
          return new ByteArrayInputStream(bytes) {
            @Override
            public void close() {
              closed++;
            }
          };
        }

        @Override
        public String name(String path) {
          return "here/" + path;
        }
      };

  private SceneFile read(String text) {
    return Resources.read(text.getBytes(StandardCharsets.UTF_8), "f.yaml", folder);
  }

  private static List<String> lines(List<Problem> problems) {
    return problems.stream().map(Problem::toString).collect(Collectors.toList());
  }

  @Test
  void aModelIsReadOnceAndSharedByAllScenes() {
    SceneFile file =
        read(
            "scenes:\n  a:\n"
                + CAMERA
                + "      - mesh: {file: models/square.obj}\n"
                + "      - mesh: {file: models/square.obj, scale: 2, translate: [0, 1, 0]}\n"
                + "      - mesh: {file: models/odd.obj}\n"
                + "  b:\n"
                + CAMERA
                + "      - mesh: {file: models/square.obj}\n");
    assertEquals(List.of(), file.problems());
    assertEquals(List.of("models/square.obj", "models/odd.obj"), opened);
    assertEquals(2, closed);
    List<Placement> a = file.scenes().get(0).placements();
    Mesh square = (Mesh) a.get(0).surface();
    assertSame(square, a.get(1).surface());
    assertSame(square, file.scenes().get(1).placements().get(0).surface());
    assertNotSame(square, a.get(2).surface());
    assertEquals(1, MeshFacts.area(square), 0);
    assertEquals(new Vector3d(2, 3, 2), a.get(1).toWorld().point(new Vector3d(1, 1, 1)));
    assertTrue(a.get(0).toWorld().isIdentity());
  }

  @Test
  void aModelIsSmoothedOncePerAngleAndStillReadOnce() {
    String surface = "      - mesh: {file: models/square.obj, smooth: ";
    SceneFile file =
        read(
            "scenes:\n  a:\n"
                + CAMERA
                + surface
                + "60}\n"
                + surface
                + "60.0}\n"
                + surface
                + "7}\n");
    assertEquals(List.of(), file.problems());
    assertEquals(List.of("models/square.obj"), opened);
    List<Placement> a = file.scenes().get(0).placements();
    assertSame(a.get(0).surface(), a.get(1).surface());
    assertNotSame(a.get(0).surface(), a.get(2).surface());
    assertTrue(((Mesh) a.get(0).surface()).isSmooth());
  }

  @Test
  void notesOfAModelAreToldOnceAndTheSceneIsComplete() {
    SceneFile file =
        read(
            "scenes:\n  a:\n"
                + CAMERA
                + "      - mesh: {file: models/odd.obj}\n"
                + "      - mesh: {file: models/odd.obj}\n");
    assertEquals(1, file.scenes().size());
    assertEquals(
        List.of(
            "here/models/odd.obj:5:1: a face repeats a corner, which is taken once",
            "here/models/odd.obj:5:1: a face needs three different corners: this one is left out"),
        lines(file.notes()));
  }

  @Test
  void aBrokenModelBreaksEverySceneThatNamesIt() {
    SceneFile file =
        read(
            "scenes:\n  a:\n"
                + CAMERA
                + "      - mesh: {file: models/broken.obj}\n"
                + "  b:\n"
                + CAMERA
                + "      - mesh: {file: models/square.obj}\n"
                + "  c:\n"
                + CAMERA
                + "      - mesh: {file: models/broken.obj}\n"
                + "      - sphere: {radius: 1}\n");
    assertEquals(List.of("a", "c"), file.broken());
    assertEquals("b", file.scenes().get(0).name());
    assertEquals(
        List.of(
            "f.yaml:14:17: a sphere needs 'center'",
            "here/models/broken.obj:2:7: expected a number, but found 'zero'",
            "here/models/broken.obj:3:7: no point 3: there are 2 points in the model"),
        lines(file.problems()));
    assertEquals(List.of("models/broken.obj", "models/square.obj"), opened);
  }

  @Test
  void aStreamThatFailsIsAProblemOfItsPlace() {
    InputStream broken =
        new InputStream() {
          @Override
          public int read() throws IOException {
            throw new IOException("the disk is on fire");
          }

          @Override
          public int read(byte[] to, int from, int most) throws IOException {
            return read();
          }
        };
    byte[] scene =
        ("scenes:\n  a:\n" + CAMERA + "      - mesh: {file: x.OBJ}\n")
            .getBytes(StandardCharsets.UTF_8);
    assertEquals(
        List.of("f.yaml:5:22: cannot read 'x.OBJ': the disk is on fire"),
        lines(Resources.read(scene, "f.yaml", path -> broken).problems()));
  }

  private static List<String> names(Placement placement) {
    return placement.materials().stream().map(NamedMaterial::name).collect(Collectors.toList());
  }

  @Test
  void aModelKeepsItsOwnMaterialsUnlessTheSceneWritesOne() {
    SceneFile file =
        read(
            "materials: {gold: {diffuse: 0.5}}\nscenes:\n  a:\n"
                + CAMERA
                + "      - mesh: {file: models/painted.obj}\n"
                + "      - mesh: {file: models/painted.obj, material: gold}\n"
                + "      - mesh: {file: models/painted.obj, material: {diffuse: 0.25}}\n"
                + "      - mesh: {file: models/square.obj}\n"
                + "  b:\n    materials: {default: {diffuse: 0.125}}\n"
                + CAMERA
                + "      - mesh: {file: models/painted.obj}\n");
    assertEquals(List.of(), file.problems());
    assertEquals(
        List.of("here/models/painted.mtl:7:1: 'map_Bump' has no effect here"), lines(file.notes()));
    assertEquals(List.of("models/painted.obj", "models/painted.mtl", "models/square.obj"), opened);
    assertEquals(3, closed);

    List<Placement> a = file.scenes().get(0).placements();
    assertEquals(List.of("", "bright red", "blue"), names(a.get(0)));
    Mesh mesh = (Mesh) a.get(0).surface();
    List<Integer> parts = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      parts.add(mesh.part(i));
    }
    assertEquals(List.of(0, 0, 1, 1, 2, 2, 1, 1), parts);
    List<NamedMaterial> own = a.get(0).materials();
    assertEquals(Material.WHITE, own.get(0).material());
    assertEquals(new Rgb(1, 0, 0), own.get(1).material().diffuse());
    assertEquals(new Rgb(0, 0, 1), own.get(2).material().diffuse());
    assertEquals(50, own.get(2).material().shininess());
    assertEquals(List.of("gold"), names(a.get(1)));
    assertEquals(Rgb.grey(0.5), a.get(1).material().diffuse());
    assertEquals(List.of(""), names(a.get(2)));
    assertEquals(Rgb.grey(0.25), a.get(2).material().diffuse());
    assertEquals(List.of(""), names(a.get(3)));
    assertEquals(Material.WHITE, a.get(3).material());

    Placement b = file.scenes().get(1).placements().get(0);
    assertSame(mesh, b.surface());
    assertEquals(Rgb.grey(0.125), b.material().diffuse(), "the default is the scene's");
    assertSame(own.get(1).material(), b.materials().get(1).material());
  }

  @Test
  void librariesThatNoSceneNeedsAreNotRead() {
    SceneFile file =
        read(
            "scenes:\n  a:\n"
                + CAMERA
                + "      - mesh: {file: models/unpainted.obj, material: {}}\n"
                + "      - mesh: {file: models/mispainted.obj, material: {}}\n");
    assertEquals(List.of(), file.notes());
    assertEquals(List.of(), file.problems());
    assertEquals(List.of("models/unpainted.obj", "models/mispainted.obj"), opened);
  }

  @Test
  void aMissingLibraryIsToldOnceAndTheSceneIsComplete() {
    String surface = "      - mesh: {file: models/unpainted.obj}\n";
    SceneFile file =
        read("scenes:\n  a:\n" + CAMERA + surface + surface + "  b:\n" + CAMERA + surface);
    assertEquals(List.of(), file.problems());
    assertEquals(2, file.scenes().size());
    assertEquals(
        List.of(
            "here/models/unpainted.obj:1:8: material library 'nowhere.mtl' cannot be read:"
                + " no such file"),
        lines(file.notes()));
    assertEquals(List.of("gone"), names(file.scenes().get(0).placements().get(0)));
    assertEquals(Material.WHITE, file.scenes().get(0).placements().get(0).material());
  }

  @Test
  void aBrokenLibraryBreaksTheScenesThatNeedIt() {
    String surface = "      - mesh: {file: models/mispainted.obj";
    SceneFile file =
        read(
            "scenes:\n  a:\n"
                + CAMERA
                + surface
                + "}\n  b:\n"
                + CAMERA
                + surface
                + ", material: {}}\n  c:\n"
                + CAMERA
                + surface
                + "}\n");
    assertEquals(List.of("a", "c"), file.broken());
    assertEquals("b", file.scenes().get(0).name());
    assertEquals(
        List.of("here/models/mispainted.mtl:2:8: expected a number, but found 'zero'"),
        lines(file.problems()));
  }
}
