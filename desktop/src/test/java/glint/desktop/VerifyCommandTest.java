package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code glint verify FILE}: scenes that carry their own answers. */
class VerifyCommandTest {

  private static final String HEAD =
      """
      defaults:
        image: {width: 4, height: 2}
        camera: {position: [0, 0, 5], look_at: [0, 0, 0], orthographic: 2}
      scenes:
      """;

  /** A glowing half plane over black: the two columns on the left are lit. */
  private static final String HALF =
      """
          surfaces:
            - quad: {corner: [-9, -9, 0], edge1: [9, 0, 0], edge2: [0, 18, 0], material: {emission: [1, 0.5, 0]}}
      """;

  @TempDir private Path dir;

  private Path write(String name, String... scenes) throws IOException {
    return Files.writeString(dir.resolve(name), HEAD + String.join("", scenes));
  }

  private static String scene(String name, String expect) {
    return "  " + name + ":\n" + HALF + (expect.isEmpty() ? "" : "    expect: " + expect + "\n");
  }

  private static final String GOOD =
      "[{pixel: [1, 1], value: [1, 0.5, 0], relative: 1e-15}, {pixel: [2, 0], value: 0, relative: 1},"
          + " {mean: [0.5, 0.25, 0], tolerance: 1e-15}]";

  @Test
  void whatIsAsExpectedPasses() throws IOException {
    Run run = Run.of("verify", write("a.yaml", scene("half", GOOD), scene("silent", "")));
    assertEquals(0, run.exitCode(), run.err());
    assertEquals("", run.err());
    List<String> lines = run.out().lines().toList();
    assertEquals(5, lines.size(), run.out());
    assertTrue(lines.get(1).matches("half#1 .*pixel 1,1 is \\[1.0, 0.5, 0.0\\].*"), run.out());
    assertTrue(lines.get(2).matches("half#2 .*pixel 2,0 is 0.0"), run.out());
    assertTrue(lines.get(3).matches("half#3 .*mean is \\[0.5, 0.25, 0.0\\].*"), run.out());
    assertEquals("3 cases, 0 wrong", lines.get(4));
  }

  @Test
  void whatIsNotAsExpectedSaysHowToSeeIt() throws IOException {
    String wrong = "[{pixel: [1, 1], value: [1, 0.75, 0], tolerance: 0.125, depth: 3}]";
    String alsoWrong = "[{mean: 0.5, tolerance: 0.3, relative: 0.1, samples: 4}]";
    Path file = write("a.yaml", scene("one", wrong), scene("my (two)", alsoWrong));
    Run run = Run.of("verify", file);
    assertEquals(1, run.exitCode());
    List<String> lines = run.out().lines().toList();
    String said = "WRONG: pixel 1,1 must be [1.0, 0.75, 0.0], but is [1.0, 0.5, 0.0] [radiance]";
    assertTrue(lines.get(1).endsWith(said), run.out());
    said = "  to see it: glint replay " + file + " --scene one --pixel 1,1 --samples 1 --depth 3";
    assertEquals(said, lines.get(2));
    said = "WRONG: mean must be 0.5, but is [0.5, 0.25, 0.0] [radiance]";
    assertTrue(lines.get(3).endsWith(said), run.out());
    said = "  to see it: glint render " + file + " --scene 'my (two)' --samples 4 --depth 64";
    assertEquals(said, lines.get(4));
    assertTrue(run.out().endsWith("2 cases, 2 wrong\n"), run.out());
  }

  @Test
  void theRowsAsJson() throws IOException {
    String expect = "[{mean: [0.5, 0.25, 0.125], tolerance: 0.0625}]";
    Run run = Run.of("verify", "--json", write("a.yaml", scene("half", expect)));
    assertEquals(1, run.exitCode());
    JsonObject row =
        JsonParser.parseString(run.out())
            .getAsJsonObject()
            .getAsJsonArray("cases")
            .get(0)
            .getAsJsonObject();
    assertEquals(
        Set.of("id", "what", "tried", "wrong", "worst", "bound", "unit", "passed"), row.keySet());
    assertEquals("half", row.get("id").getAsString());
    assertTrue(row.get("what").getAsString().contains("; to see it: glint render "), run.out());
    assertEquals(1, row.get("tried").getAsLong());
    assertEquals(1, row.get("wrong").getAsLong());
    assertEquals(0.125, row.get("worst").getAsDouble());
    assertEquals(0.0625, row.get("bound").getAsDouble());
    assertEquals("radiance", row.get("unit").getAsString());
    assertEquals(false, row.get("passed").getAsBoolean());
  }

  @Test
  void aFileThatExpectsNothingIsNoSuccess() throws IOException {
    Path silent = write("silent.yaml", scene("one", ""), scene("two", ""));
    Path good = write("good.yaml", scene("half", GOOD));
    Run run = Run.of("verify", good, silent);
    assertEquals(1, run.exitCode());
    String why = ": no scene says by 'expect' what its picture must show: nothing to verify";
    assertEquals(List.of(silent + why), run.errLines());
    assertTrue(run.out().endsWith("3 cases, 0 wrong\n"), run.out());
    Path course = dir.resolve("a.txt");
    Files.writeString(course, "Camera 0 0 8 0 1 0 0 0 0 40 1\nOutput 4 4 a.png\nSphere 0 0 0 1\n");
    run = Run.of("verify", course);
    assertEquals(1, run.exitCode());
    assertEquals(List.of(course + why), run.errLines());
  }

  @Test
  void aProblemOfOneSceneDoesNotHideTheOthers() throws IOException {
    Path file = write("a.yaml", scene("half", GOOD), scene("bad", "[{mean: 1}]"));
    Run run = Run.of("verify", file);
    assertEquals(1, run.exitCode());
    assertEquals(
        List.of(file + ":12:14: an expectation needs 'tolerance' or 'relative'"), run.errLines());
    assertTrue(run.out().endsWith("3 cases, 0 wrong\n"), run.out());
    assertEquals(1, Run.of("verify", dir.resolve("nowhere.yaml")).exitCode());
  }
}
