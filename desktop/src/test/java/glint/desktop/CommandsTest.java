package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.render.Aov;
import glint.render.RenderSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CommandsTest {

  @TempDir private Path dir;

  @Test
  void theUsageListsTheCommands() {
    Run run = Run.of("--help");
    assertTrue(run.out().startsWith("Usage: glint"), run.out());
    for (String command : List.of("render", "plan", "check", "compare", "window")) {
      assertTrue(run.out().contains("\n  " + command + " "), command);
      Run help = Run.of(command, "--help");
      assertEquals(0, help.exitCode());
      assertTrue(help.out().startsWith("Usage: glint " + command), help.out());
    }
    assertEquals(0, run.exitCode());
  }

  @Test
  void withoutADisplayTheWindowNamesTheCommandThatNeedsNone() {
    String line = "glint: there is no display to open a window on; 'glint render FILE' renders";
    for (Run run : List.of(Run.of(), Run.of("window"), Run.of("window", "no.yaml"))) {
      assertEquals(1, run.exitCode());
      assertEquals("", run.out());
      assertEquals(List.of(line + " without one"), run.errLines());
    }
    assertEquals(2, Run.of("window", "--scene", "x").exitCode());
  }

  @Test
  void versionSaysWhatRuns() {
    Run run = Run.of("--version");
    assertEquals(0, run.exitCode());
    List<String> lines = run.out().lines().toList();
    assertTrue(lines.get(0).matches("glint \\d+\\.\\d+\\.\\d+.*"), run.out());
    assertTrue(lines.get(1).startsWith("Java " + System.getProperty("java.version")), run.out());
    assertEquals("kernel scalar", lines.get(2));
  }

  @Test
  void aMistypedCommandGetsASuggestion() {
    Run run = Run.of("rendr", "x");
    assertEquals(2, run.exitCode());
    assertTrue(run.err().contains("glint render"), run.err());
  }

  @Test
  void completionIsGenerated() {
    Run run = Run.of("generate-completion");
    assertEquals(0, run.exitCode());
    assertTrue(run.out().contains("--samples"), run.out());
  }

  @Test
  void checkPassesGoodFilesAndListsAllThatIsWrong() throws IOException {
    Path good = Scenes.write(dir.resolve("good.yaml"), "one", "two");
    Path single = Scenes.write(dir.resolve("single.yaml"), "one");
    Run run = Run.of("check", good, single);
    assertEquals(0, run.exitCode());
    assertEquals("", run.err());
    String expected = good + ": 2 scenes, no problems\n" + single + ": 1 scene, no problems\n";
    assertEquals(expected, run.out().replace("\r\n", "\n"));
    Path bad = dir.resolve("bad.yaml");
    String text = Files.readString(good).replace("radius: 1", "radius: 0");
    Files.writeString(bad, text.replace("fov: 40", "fov: 400"));
    run = Run.of("check", bad, good);
    assertEquals(1, run.exitCode());
    assertTrue(run.errLines().size() >= 3, run.err());
    for (String line : run.errLines()) {
      assertTrue(line.startsWith(bad + ":"), line);
    }
    assertEquals(good + ": 2 scenes, no problems", run.out().trim());
  }

  @Test
  void notesAreNoProblems() throws IOException {
    Path file = dir.resolve("a.txt");
    Files.writeString(
        file,
        "Camera 0 0 8 0 1 0 0 0 0 40 1\nOutput 4 4 a.png\nBounceDepth 1\nShadowBias 0.1\n"
            + "Material 0 0 0 1 1 1 0 0 0 0 0 0 1\nSphere 0 0 0 1\n");
    Run run = Run.of("check", file);
    assertEquals(0, run.exitCode(), run.err());
    assertTrue(run.out().startsWith(file + ":4:1: note: ShadowBias"), run.out());
    run = Run.of("render", file, "--out", dir.resolve("out"), "--quiet");
    assertEquals(new Run(0, "", ""), run);
  }

  @Test
  void planPrintsEveryDecisionWithItsReason() throws IOException {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    Run run = Run.of("plan", file, "--scene", "two");
    assertEquals(0, run.exitCode(), run.err());
    assertTrue(run.out().startsWith("two: 40x30, 2 primitives"), run.out());
    assertTrue(run.out().matches("(?s).*mirror rays +yes +reflecting surfaces: 2.*"), run.out());
    assertTrue(run.out().matches("(?s).*sky gradient +no +.*"), run.out());
    assertFalse(run.out().contains("one:"));
    assertEquals(2, Run.of("plan", file, "--scene", "tow").exitCode());
    assertEquals(1, Run.of("plan", dir.resolve("nowhere.yaml")).exitCode());
  }

  @Test
  void theLimitsOfTheOptionsAreThoseOfTheRenderer() {
    int samples = RenderSettings.MAX_SAMPLES;
    int depth = RenderSettings.MAX_DEPTH;
    int threads = RenderSettings.MAX_THREADS;
    int tile = RenderSettings.MAX_TILE;
    settings(samples, depth, threads, tile);
    assertBad(() -> settings(samples + 1, depth, threads, tile));
    assertBad(() -> settings(samples, depth + 1, threads, tile));
    assertBad(() -> settings(samples, depth, threads + 1, tile));
    assertBad(() -> settings(samples, depth, threads, tile + 1));
  }

  private static void settings(int samples, int depth, int threads, int tile) {
    Set<Aov> none = Set.of();
    new RenderSettings(1, 1, samples, 0, OptionalInt.of(depth), threads, tile, none);
  }

  private static void assertBad(org.junit.jupiter.api.function.Executable settings) {
    assertThrows(IllegalArgumentException.class, settings);
  }
}
