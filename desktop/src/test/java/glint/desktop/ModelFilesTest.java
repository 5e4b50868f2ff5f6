package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Models are found beside the scene file that names them, and belong to what --resume compares. */
class ModelFilesTest {

  private static final String SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";

  @TempDir private Path dir;

  private Path file;
  private Path model;
  private Path out;

  @BeforeEach
  void write() throws IOException {
    Path folder = Files.createDirectories(dir.resolve("scenes/models")).getParent();
    model = Files.writeString(folder.resolve("models/square.obj"), SQUARE);
    file = folder.resolve("a.yaml");
    scene("models/square.obj");
    out = dir.resolve("out");
  }

  /** Writes a scene with a model, and one without. */
  private void scene(String path) throws IOException {
    Files.writeString(
        file,
        """
        defaults:
          image: {width: 20, height: 15}
          camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}
          lights: [{ambient: {color: 0.5}}]
        scenes:
          with:
            surfaces:
              - mesh: {file: "%s", rotate: {axis: [0, 0, 1], degrees: 10}}
          without: {}
        """
            .formatted(path));
  }

  private Run render(int exitCode, String... options) {
    List<Object> args = new ArrayList<>(List.of("render", file, "--out", out, "--samples", 1));
    Collections.addAll(args, (Object[]) options);
    Run run = Run.of(args.toArray());
    assertEquals(exitCode, run.exitCode(), run.err());
    return run;
  }

  private static long kept(Run run) {
    return run.errLines().stream().filter(line -> line.contains(": kept ")).count();
  }

  @Test
  void pathsAreRelativeToTheSceneFileOrAbsolute() throws IOException {
    render(0);
    Map<String, String> relative = Run.digests(out);
    assertNotEquals(relative.get("with.png"), relative.get("without.png"));
    scene(model.toAbsolutePath().toString().replace("\\", "\\\\"));
    render(0, "--format", "pfm");
    scene("../scenes/models/square.obj");
    render(0, "--format", "pfm", "--resume");
  }

  @Test
  void aModelThatCannotBeReadIsNamedAtItsPlace() throws IOException {
    Map<String, String> reasons =
        Map.of(
            "models/none.obj", "no such file or folder",
            "none/square.obj", "no such file or folder",
            "models.obj", "is a folder, not a file",
            "\\0.obj", "cannot be a file's name here");
    Files.createDirectory(file.resolveSibling("models.obj"));
    for (Map.Entry<String, String> each : reasons.entrySet()) {
      scene(each.getKey());
      Run run = render(1);
      String begin = file + ":8:22: cannot read '";
      assertTrue(
          run.errLines().stream()
              .anyMatch(line -> line.startsWith(begin) && line.contains(each.getValue())),
          run.err());
      assertEquals(List.of("without.png"), Run.list(out));
    }
  }

  @Test
  void problemsAndNotesOfAModelHaveItsName() throws IOException {
    Files.writeString(model, SQUARE + "f 1 2 5\n");
    Run run = Run.of("check", file);
    assertEquals(1, run.exitCode());
    assertEquals(
        List.of(model + ":6:7: no point 5: there are 4 points in the model"), run.errLines());
    Files.writeString(model, SQUARE + "f 1 2\n");
    run = Run.of("check", file);
    assertEquals(0, run.exitCode());
    assertTrue(run.out().startsWith(model + ":6:1: note: a face needs three"), run.out());
  }

  @Test
  void aChangedModelIsRenderedAgain() throws IOException {
    render(0);
    assertEquals(2, kept(render(0, "--resume")));
    Files.writeString(model, SQUARE.replace("v 1 1", "v 1 2"));
    assertEquals(0, kept(render(0, "--resume")));
    assertEquals(2, kept(render(0, "--resume")));
  }

  @Test
  void pfmAloneMustBeNewerThanTheModel() throws IOException {
    FileTime anHourAgo = FileTime.fromMillis(System.currentTimeMillis() - 3_600_000);
    FileTime inAnHour = FileTime.fromMillis(System.currentTimeMillis() + 3_600_000);
    Files.setLastModifiedTime(file, anHourAgo);
    Files.setLastModifiedTime(model, anHourAgo);
    render(0, "--format", "pfm");
    assertEquals(2, kept(render(0, "--format", "pfm", "--resume")));
    Files.setLastModifiedTime(model, inAnHour);
    assertEquals(0, kept(render(0, "--format", "pfm", "--resume")));
  }

  @Test
  void anEmptyModelIsNoFailure() throws IOException {
    Files.writeString(model, "# nothing\n");
    Run run = render(0);
    assertTrue(run.err().contains(model + ": note: holds no faces"), run.err());
    assertEquals(List.of("with.png", "without.png"), Run.list(out));
  }

  @Test
  void materialsOfAModelBelongToIt() throws IOException {
    Files.writeString(model, "mtllib paint/red.mtl\nusemtl red\n" + SQUARE);
    Path paint = Files.createDirectories(model.resolveSibling("paint")).resolve("red.mtl");
    Run run = Run.of("check", file);
    assertEquals(0, run.exitCode(), run.err());
    assertTrue(
        run.out()
            .startsWith(
                model
                    + ":1:8: note: material library 'paint/red.mtl' cannot be read:"
                    + " no such file or folder\n"),
        run.out());
    render(0);
    assertEquals(2, kept(render(0, "--resume")));
    Files.writeString(paint, "newmtl red\nKd 1 0 0\n");
    assertEquals(0, kept(render(0, "--resume")));
    assertEquals(2, kept(render(0, "--resume")));
    Files.writeString(paint, "newmtl red\nKd 0 1 0\n");
    assertEquals(0, kept(render(0, "--resume")));
    Files.writeString(paint, "newmtl red\nKd 0 1 x\n");
    run = render(1);
    assertEquals(paint + ":2:8: expected a number, but found 'x'", run.errLines().get(0));
    Run replay = Run.of("replay", file, "--scene", "with", "--pixel", "10,7", "--samples", "1");
    assertEquals(1, replay.exitCode());
    Files.writeString(model, "mtllib " + paint.toAbsolutePath() + "\nusemtl red\n" + SQUARE);
    Files.writeString(paint, "newmtl red\nKd 0 1 0\n");
    assertEquals(file + ": 2 scenes, no problems", Run.of("check", file).out().trim());
    replay = Run.of("replay", file, "--scene", "with", "--pixel", "10,7", "--samples", "1");
    assertTrue(replay.out().contains("surface 0 (mesh of red, line 8)"), replay.out());
  }

  @Test
  void aModelAloneIsAScene() throws IOException {
    Path mtl = Files.writeString(model.resolveSibling("a.mtl"), "newmtl m\nKd 1 0 0\n");
    Files.writeString(model, "mtllib a.mtl\nusemtl m\n" + SQUARE);
    assertEquals(model + ": 1 scene, no problems\n", Run.of("check", model).out());
    assertTrue(Run.of("plan", model).out().startsWith("square: 640x480, 2 primitives"));
    Object[] render = {
      "render", model, "--out", out, "--samples", 1, "--size", "20x15", "--resume"
    };
    assertEquals(0, Run.of(render).exitCode());
    assertEquals(List.of("square.png"), Run.list(out));
    assertTrue(Run.of(render).err().contains("square: kept "));
    Files.writeString(mtl, "newmtl m\nKd 0 1 0\n");
    assertTrue(!Run.of(render).err().contains("square: kept "));

    Files.writeString(model, "v 0 0 0\n");
    Run empty = Run.of("render", model, "--out", out);
    assertEquals(1, empty.exitCode());
    assertTrue(empty.err().startsWith(model + ": holds no faces: there is nothing to be seen\n"));
    assertTrue(Run.of("verify", model).err().contains("holds no faces"));
  }
}
