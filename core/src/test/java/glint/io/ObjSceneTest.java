package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.NamedMaterial;
import glint.scene.Scene;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** A model alone is a scene: framed, lit, and made of its own materials. */
class ObjSceneTest {

  private static SceneFile read(String name, String text, Map<String, String> beside)
      throws IOException {
    SceneFolder folder =
        path -> {
          if (!beside.containsKey(path)) {
            throw new IOException("no such file");
          }
          return bytes(beside.get(path));
        };
    return SceneFiles.read(bytes(text), name, folder);
  }

  private static ByteArrayInputStream bytes(String text) {
    return new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8));
  }

  private static List<String> problems(String name, String text) throws IOException {
    return read(name, text, Map.of()).problems().stream()
        .map(Problem::toString)
        .collect(Collectors.toList());
  }

  /** Returns where a point is in the picture: across and up, 1 at the edges. */
  private static double[] place(Scene scene, Vector3d p) {
    Vector3d forward = scene.camera().lookAt().minus(scene.camera().position()).normalized();
    Vector3d right = forward.cross(scene.camera().up()).normalized();
    Vector3d d = p.minus(scene.camera().position());
    double depth = d.dot(forward);
    double half = StrictMath.tan(StrictMath.toRadians(20)) * depth;
    double up = d.dot(right.cross(forward)) / half;
    return new double[] {d.dot(right) / half * 3 / 4, up, depth};
  }

  @Test
  void theBoxAroundAllFacesFillsThePicture() throws IOException {
    Random r = new Random(3);
    for (int i = 0; i < 100; i++) {
      double size = StrictMath.pow(10, 20 * r.nextDouble() - 10);
      Vector3d e = new Vector3d(r.nextDouble(), r.nextDouble(), i % 3 == 0 ? 0 : 1).times(size);
      Vector3d at = new Vector3d(r.nextGaussian(), r.nextGaussian(), 5).times(size);
      StringBuilder text = new StringBuilder("v 1e30 0 0\n"); // of no face
      for (int k = 0; k < 8; k++) {
        Vector3d c = corner(at, e, k);
        text.append("v " + c.x() + " " + c.y() + " " + c.z() + "\n");
      }
      text.append("f 2 3 4 5\nf 6 7 8 9\n");
      Scene scene = read("m.obj", text.toString(), Map.of()).scenes().get(0);
      double most = 0;
      for (int k = 0; k < 8; k++) {
        double[] place = place(scene, corner(at, e, k));
        most = Math.max(most, Math.max(Math.abs(place[0]), Math.abs(place[1])));
        assertTrue(place[2] > 0);
      }
      assertEquals(0.9, most, 1e-9);
    }
  }

  private static Vector3d corner(Vector3d at, Vector3d e, int k) {
    return at.plus(new Vector3d((k & 1) * e.x(), (k >> 1 & 1) * e.y(), (k >> 2) * e.z()));
  }

  @Test
  void aModelIsMadeOfItsMaterialsUnderTwoLights() throws IOException {
    String text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl red\nf 3 2 1\n";
    SceneFile file = read("x/some model.OBJ", text, Map.of("a.mtl", "newmtl red\nKd 1 0 0\n"));
    assertEquals(List.of(), file.problems());
    assertEquals(List.of(), file.notes());
    Scene scene = file.scenes().get(0);
    assertEquals("some model", scene.name());
    assertEquals(2, scene.lights().size());
    List<NamedMaterial> made = scene.placements().get(0).materials();
    assertEquals(Material.WHITE, made.get(0).material());
    assertEquals("red", made.get(1).name());
    assertEquals(new Rgb(1, 0, 0), made.get(1).material().diffuse());

    SceneFile without = read("a.obj", text, Map.of());
    assertEquals(1, without.scenes().size());
    assertTrue(without.notes().get(0).toString().startsWith("a.obj:1:"), "" + without.notes());

    SceneFile bad = read("a.obj", text, Map.of("a.mtl", "newmtl red\nKd x 0 0\n"));
    assertEquals(List.of("a"), bad.broken());
    assertTrue(bad.problems().get(0).toString().startsWith("a.mtl:2:4: "), "" + bad.problems());
  }

  @Test
  void whatCannotBeShownIsAProblem() throws IOException {
    String nothing = "m/a.obj: holds no faces: there is nothing to be seen";
    for (String text : List.of("", "# empty\n", "v 0 0 0\n", "v 0 0 0\nv 1 0 0\nl 1 2\n")) {
      assertEquals(List.of(nothing), problems("m/a.obj", text));
    }
    assertEquals(
        List.of("a.obj:1:3: no point 7: there are 0 points in the model"),
        problems("a.obj", "f 7 8 9"));
    assertEquals(
        List.of(
            "a.obj: the model cannot be framed: look_at must differ from position: (1.0, 1.0, 1.0)"),
        problems("a.obj", "v 1 1 1\nf 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"));
    String far = "v 1e100 0 0\nv -1e100 0 0\nv 0 1e100 0\nf 1 2 3\n";
    assertTrue(problems("a.obj", far).get(0).startsWith("a.obj: the model cannot be framed: "));
  }

  @Test
  void aFilesNameBecomesAScenesName() throws IOException {
    String text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    Map<String, String> names =
        Map.of(
            "a/b.c.obj",
            "b.c",
            "a\\würfel (2).obj",
            "würfel (2)",
            "-.x. .obj",
            "x",
            ".obj",
            "model",
            "a:b?.obj",
            "a_b_",
            "n".repeat(300) + ".obj",
            "n".repeat(100));
    for (Map.Entry<String, String> each : names.entrySet()) {
      Scene scene = read(each.getKey(), text, Map.of()).scenes().get(0);
      assertEquals(each.getValue(), scene.name());
    }
  }
}
