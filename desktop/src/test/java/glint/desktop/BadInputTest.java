package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever is wrong with one file or option: a line that says so, and the rest is rendered. */
class BadInputTest {

  private static final String BEGIN =
      """
      materials:
        gold: {color: [1, 0.7, 0], diffuse: 0.5}
      scenes:
        good in bad:
          image: {width: 4, height: 3}
          camera: {position: [0, 0, 8], look_at: [0, 0, 0], up: [0, 1, 0], fov: 40}
          surfaces:
            - sphere: {center: [0, 0, 0], radius: 1, material: gold}
        bad:
      """;
  private static final String CAMERA =
      "    camera: {position: [0, 0, 8], look_at: [0, 0, 0], up: [0, 1, 0], fov: 40}\n";

  @TempDir private Path dir;

  /** One line of a scene that is wrong, in place of the line of its kind or besides. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "camra: {position: [0, 0, 8]}",
        "image: {width: 0, height: 0}",
        "image: {width: 100000, height: 100000}",
        "image: {width: -5, height: 5}",
        "image: {width: 4.5, height: 5}",
        "image: {width: many, height: 5}",
        "image: [4, 3]",
        "image: {width: 4, hieght: 3}",
        "image: {width: 99999999999999999999, height: 3}",
        "background: [0, 0]",
        "background: [0, 0, -1]",
        "background: [0, 0, .nan]",
        "background: '#12345'",
        "background: [.inf, 0, 0]",
        "lights: {ambient: {color: 1}}",
        "lights: [{pont: {position: [0, 0, 0], color: 1}}]",
        "lights: [{point: {position: [0, 0, 0], colour: 1}}]",
        "lights: [{directional: {direction: [0, 0, 0], color: 1}}]",
        "lights: [{point: {color: 1}}]",
        "surfaces: [{sphere: {center: [0, 0, 0], radius: 0}}]",
        "surfaces: [{sphere: {center: [0, 0, 0], radius: -1}}]",
        "surfaces: [{sphere: {center: [0, 0, 0], radius: .nan}}]",
        "surfaces: [{sphere: {center: [0, 0, 0], radius: 1e300}}]",
        "surfaces: [{sphere: {center: [0, 0, 0]}}]",
        "surfaces: [{sphere: {center: [0, 0], radius: 1}}]",
        "surfaces: [{sphere: {center: [0, 0, 0], radius: one}}]",
        "surfaces: [{sphere: {center: [0, 0, 0], radius: 1, material: gld}}]",
        "surfaces: [{spere: {center: [0, 0, 0], radius: 1}}]",
        "surfaces: [{triangle: {vertices: [[0, 0, 0], [1, 0, 0]]}}]",
        "surfaces: [{plane: {point: [0, 0, 0], normal: [0, 0, 0]}}]",
        "surfaces: [sphere]",
        "surfaces: 7",
        "highlights: bling",
        "transfer: gamma",
        "surfaces: *nowhere",
        "surfaces: &a [*a]",
        "surfaces: [",
        "surfaces: {sphere: {a: 1, a: 2}}",
      })
  void aWrongSceneIsNamedWithItsPlace(String line) throws IOException {
    String scene = line.startsWith("camra") ? "" : CAMERA;
    check("bad.yaml", BEGIN + scene + "    " + line + "\n", true);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "camera: {position: [0, 0, 8], look_at: [0, 0, 8], up: [0, 1, 0], fov: 40}",
        "camera: {position: [0, 0, 8], look_at: [0, 0, 0], up: [0, 0, 2], fov: 40}",
        "camera: {position: [0, 0, 8], look_at: [0, 0, 0], up: [0, 0, 0], fov: 40}",
        "camera: {position: [0, 0, 8], look_at: [0, 0, 0], up: [0, 1, 0], fov: 180}",
        "camera: {position: [0, 0, 8], look_at: [0, 0, 0], up: [0, 1, 0], fov: wide}",
        "camera: {look_at: [0, 0, 0], up: [0, 1, 0], fov: 40}",
        "camera: 5",
      })
  void aWrongCameraIsNamedWithItsPlace(String line) throws IOException {
    check("bad.yaml", BEGIN + "    " + line + "\n", true);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "just words",
        "- a\n- b",
        "scenes:",
        "scenes: {}",
        "scene:\n  a: 1",
        "scenes:\n\ta: 1",
        "scenes:\n  a: 1\n  a: 2",
        "scenes:\n  ../evil: {}",
        "\u0000\u0001\u0002binary",
        "a: &a [x, x]\nb: &b [*a, *a]\nc: &c [*b, *b]\nd: [*c, *c]",
      })
  void aFileThatIsNoSceneFileIsNamed(String text) throws IOException {
    check("bad.yaml", text, false);
    check("bad.yml", text, false);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Camera 1 2 3",
        "Camera 0 0 8 0 1 0 0 0 0 40 1\nOutput 4 4 a.png\nBall 0 0 0 1",
        "Camera 0 0 8 0 1 0 0 0 0 40 1\nOutput 4 4 a.png\nSphere 0 0 0 zero",
        "Camera 0 0 8 0 1 0 0 0 0 40 1\nOutput 4 4 a.png\nSphere 0 0 0 0",
        "Camera 0 0 8 0 1 0 0 0 8 40 1\nOutput 4 4 a.png\nSphere 0 0 0 1",
        "Camera 0 0 8 0 1 0 0 0 0 40 1\nOutput 0 4 a.png\nSphere 0 0 0 1",
        "Camera 0 0 8 0 1 0 0 0 0 40 1\nOutput 4 4 a.png\nPopMatrix",
        "sphere 0 0 0 1",
      })
  void aWrongCs315FileIsNamedWithItsPlace(String text) throws IOException {
    check("bad.txt", text, true);
  }

  @Test
  void whatIsNoReadableFileIsNamed() throws IOException {
    Files.createDirectory(dir.resolve("folder.yaml"));
    byte[] random = new byte[5000];
    new java.util.Random(1).nextBytes(random);
    Files.write(dir.resolve("random.yaml"), random);
    Files.write(
        dir.resolve("latin1.yaml"), "title: Gr\u00fcn".getBytes(StandardCharsets.ISO_8859_1));
    Files.writeString(dir.resolve("scene.png"), "x");
    for (String name :
        List.of("folder.yaml", "random.yaml", "latin1.yaml", "scene.png", "nowhere.yaml", ".")) {
      Path bad = dir.resolve(name);
      Run run = renderBeside(bad);
      assertEquals(1, run.exitCode());
      assertTrue(run.err().contains(bad + ":"), run.err());
      assertClean(run);
      assertEquals(List.of("good.png"), Run.list(dir.resolve("out")));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--threads 0       | --threads must be 1 to",
        "--threads -1      | --threads must be 1 to",
        "--threads 100000  | --threads must be 1 to",
        "--threads two     | 'two' is not an int",
        "--tile 0          | --tile must be 1 to",
        "--samples 0       | --samples must be 1 to",
        "--samples -3      | --samples must be 1 to",
        "--samples 1e3     | '1e3' is not an int",
        "--samples         | Missing required parameter",
        "--depth -1        | --depth must be 0 to",
        "--seed x          | 'x' is not a long",
        "--size 0x0        | width must be at least 1",
        "--size 4x0        | height must be at least 1",
        "--size 100000x100000 | must be at most",
        "--size 999999999999x1 | must be columns x rows",
        "--size 4          | such as 640x480",
        "--size 4X4        | such as 640x480",
        "--size -4x4       | such as 640x480",
        "--format jpg      | png, pfm, both, but not 'jpg'",
        "--format PNG      | did you mean 'png'?",
        "--aov depht       | did you mean 'depth'?",
        "--aov depth,,id   | depth, normal, albedo, id, samples, error, but not ''",
        "--sampels 4       | --samples",
        "--max-error 0     | --max-error must be more than 0 and at most 255, but is 0.0",
        "--max-error 300   | --max-error must be more than 0 and at most 255",
        "--max-error NaN   | --max-error must be more than 0 and at most 255",
        "--max-error 1 --samples 4  | --samples leaves nothing to --max-error",
        "--time-limit 3s --samples 4 | --samples leaves nothing to --time-limit",
        "--time-limit 30   | --time-limit must be a time such as 30s, 5m or 1h, but is '30'",
        "--time-limit 0s   | --time-limit must be a time such as 30s",
        "--samples 4 --samples 5 | only once",
      })
  void aWrongOptionIsExplained(String options, String expected) throws IOException {
    Path good = Scenes.write(dir.resolve("good.yaml"), "good");
    String[] words = ("render " + good + " --out " + dir.resolve("out") + " " + options).split(" ");
    Run run = Run.of((Object[]) words);
    assertEquals(2, run.exitCode());
    assertTrue(run.err().contains(expected), run.err());
    assertTrue(run.err().endsWith("Try 'glint render --help'." + System.lineSeparator()));
    assertTrue(run.errLines().size() <= 3, run.err());
    assertClean(run);
    assertFalse(Files.exists(dir.resolve("out")));
  }

  @Test
  void anEmptyNameIsNoFile() {
    for (String[] words :
        List.of(new String[] {"check", ""}, new String[] {"render", "a", "--out", ""})) {
      Run run = Run.of((Object[]) words);
      assertEquals(2, run.exitCode());
      assertTrue(run.err().contains("the name of a file or folder is empty"), run.err());
    }
  }

  @Test
  void whereNothingCanBeWrittenIsSaidBeforeRendering() throws IOException {
    Path good = Scenes.write(dir.resolve("good.yaml"), "good");
    Path file = Files.writeString(dir.resolve("file"), "x");
    assertFailure(Run.of("render", good, "--out", file), file + ": is a file, not a folder");
    assertFailure(
        Run.of("render", good, "--out", file.resolve("below")), "cannot make the folder " + file);
    Run run = Run.of("render", good, "--out", dir.resolve("out"), "--stats", dir);
    assertFailure(run, "cannot write " + dir + ": is a folder");
    assertEquals("x", Files.readString(file));
    assertFalse(Files.exists(dir.resolve("out")));
  }

  @Test
  void theSummaryNamesTheScenesThatCouldNotBeRead() throws IOException {
    String text = "\n  broken: {camera: 1}\n  broken-too: {camera: 2}\n";
    Path file = Scenes.write(dir.resolve("mixed.yaml"), "good");
    Files.writeString(file, Files.readString(file).stripTrailing() + text);
    Run run = Run.of("render", file, "--out", dir.resolve("out"));
    assertEquals(1, run.exitCode());
    String summary = "1 of 3 scenes are finished; failed: " + file + " (broken, broken-too)";
    assertTrue(run.err().contains(summary), run.err());
    assertEquals(List.of("good.png"), Run.list(dir.resolve("out")));
  }

  @Test
  void aFolderInPlaceOfAnImageFailsThatSceneOnly() throws IOException {
    Path good = Scenes.write(dir.resolve("good.yaml"), "first", "good");
    Path taken = Files.createDirectories(dir.resolve("out/first.png/inside"));
    Run run = Run.of("render", good, "--out", dir.resolve("out"), "--stats", dir.resolve("s.json"));
    assertEquals(1, run.exitCode());
    assertTrue(run.err().contains("first: cannot write " + taken.getParent() + ": "), run.err());
    assertTrue(run.err().contains("1 of 2 scenes are finished; failed: first"), run.err());
    assertClean(run);
    assertEquals(List.of("first.png", "good.png"), Run.list(dir.resolve("out")));
    String stats = Files.readString(dir.resolve("s.json"));
    assertTrue(stats.contains("\"failed\": [\n    {\n      \"name\": \"first\""), stats);
  }

  private void check(String fileName, String text, boolean hasPlace) throws IOException {
    Path bad = Files.writeString(dir.resolve(fileName), text);
    Run run = renderBeside(bad);
    assertEquals(1, run.exitCode());
    String place = Pattern.quote(bad + ":") + (hasPlace ? "[1-9][0-9]*:[1-9][0-9]*: " : "") + ".+";
    assertTrue(run.errLines().stream().anyMatch(line -> line.matches(place)), run.err());
    assertClean(run);
    List<String> rest = Run.list(dir.resolve("out"));
    assertTrue(rest.contains("good.png"), rest + run.err());
    assertFalse(rest.contains("bad.png"), rest + run.err());
    assertTrue(rest.stream().allMatch(name -> name.matches("good( in bad)?\\.png")), "" + rest);
    Run checked = Run.of("check", bad);
    assertEquals(1, checked.exitCode());
    assertTrue(checked.errLines().stream().allMatch(l -> l.startsWith(bad + ":")), checked.err());
  }

  private Run renderBeside(Path bad) throws IOException {
    Path good = Scenes.write(dir.resolve("good.yaml"), "good");
    Path out = dir.resolve("out");
    return Run.of("render", bad, good, "--out", out, "--samples", 1, "--size", "4x3");
  }

  private static void assertFailure(Run run, String expected) {
    assertEquals(1, run.exitCode());
    assertTrue(run.err().contains(expected), run.err());
    assertEquals(1, run.errLines().size(), run.err());
    assertClean(run);
  }

  private static void assertClean(Run run) {
    assertFalse(run.err().contains("Exception"), run.err());
    assertFalse(run.err().contains("\tat "), run.err());
    assertFalse(run.err().contains("internal error"), run.err());
  }
}
