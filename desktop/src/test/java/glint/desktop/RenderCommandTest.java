package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import glint.color.Transfer;
import glint.image.Image;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RenderCommandTest {

  @TempDir private Path dir;

  private Path out() {
    return dir.resolve("out");
  }

  @Test
  void everySceneOfEveryFileBecomesOneImage() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    Path b = Scenes.write(dir.resolve("b.yaml"), "three");
    Run run = Run.of("render", a, b, "--out", out());
    assertEquals(0, run.exitCode(), run.err());
    assertEquals(List.of("one.png", "three.png", "two.png"), Run.list(out()));
    assertEquals(3, run.errLines().size(), run.err());
    String line = run.errLines().get(0);
    String expected =
        "one: 40x30, [0-9.]+ samples, error [0-9.]+ levels, [0-9.]+ s, [0-9.]+ [kM] rays/s -> .*one\\.png";
    assertTrue(line.matches(expected), line);
    assertEquals("", run.out());
  }

  @Test
  void quietSaysNothingWhenAllIsWell() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    assertEquals(new Run(0, "", ""), Run.of("render", a, "--out", out(), "--quiet"));
  }

  @Test
  void pngHoldsTheCodesOfThePfm() throws Exception {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    assertEquals(0, Run.of("render", a, "--out", out(), "--format", "both").exitCode());
    Image linear = ImageFiles.read(out().resolve("one.pfm"), Transfer.SRGB);
    BufferedImage png = ImageIO.read(out().resolve("one.png").toFile());
    assertFalse(png.getColorModel().hasAlpha());
    assertEquals(24, png.getColorModel().getPixelSize());
    int[] expected = linear.toArgb(Transfer.SRGB);
    int[] actual = png.getRGB(0, 0, 40, 30, null, 0, 40);
    int different = 0;
    for (int i = 0; i < expected.length; i++) {
      different += expected[i] == actual[i] ? 0 : 1;
    }
    // The PFM's floats may round a value across the border between two codes
    assertTrue(different <= 2, different + " pixels differ");
  }

  @Test
  void sizeAndSamplesOverrideTheScene() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    Path stats = dir.resolve("deep/er/stats.json");
    Run run =
        Run.of("render", a, "--out", out(), "--size", "17x9", "--samples", 3, "--stats", stats);
    assertEquals(0, run.exitCode(), run.err());
    PngInfo info = PngInfo.read(out().resolve("one.png"));
    assertEquals(17, info.width());
    assertEquals(9, info.height());
    JsonObject scene = scene(stats, 0);
    assertEquals(17 * 9 * 3, scene.getAsJsonObject("rays").get("camera").getAsInt());
    assertEquals("{\"min\":3,\"mean\":3.0,\"max\":3}", scene.get("samples").toString());
  }

  @Test
  void extraImagesShowWhatTheCentreOfAPixelSees() throws Exception {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    Run run = Run.of("render", a, "--out", out(), "--aov", "depth,id", "--aov", "normal,albedo");
    assertEquals(2, run.exitCode(), "an option is given once: " + run.err());
    run = Run.of("render", a, "--out", out(), "--aov", "depth,id,normal,albedo");
    assertEquals(0, run.exitCode(), run.err());
    assertEquals(
        List.of("one.albedo.pfm", "one.depth.pfm", "one.id.pfm", "one.normal.pfm", "one.png"),
        Run.list(out()));
    int middle = 3 * (15 * 40 + 20);
    Image id = ImageFiles.read(out().resolve("one.id.pfm"), Transfer.SRGB);
    assertEquals(0, id.rgb()[middle], "the ball is the first surface");
    Image depth = ImageFiles.read(out().resolve("one.depth.pfm"), Transfer.SRGB);
    double toCentre = Math.sqrt(65);
    assertTrue(depth.rgb()[middle] > toCentre - 1.001 && depth.rgb()[middle] < toCentre);
  }

  @Test
  void statisticsHaveTheNamesOfTheContract() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    Path stats = dir.resolve("stats.json");
    Run run = Run.of("render", a, "--out", out(), "--threads", 3, "--stats", stats);
    assertEquals(0, run.exitCode(), run.err());
    JsonObject json = JsonParser.parseString(Files.readString(stats)).getAsJsonObject();
    assertEquals(
        Set.of("version", "java", "threads", "scenes", "failed", "interrupted"), json.keySet());
    assertEquals(3, json.get("threads").getAsInt());
    assertEquals(2, json.getAsJsonArray("scenes").size());
    JsonObject scene = scene(stats, 1);
    assertEquals("two", scene.get("name").getAsString());
    assertEquals(Set.of("load", "build", "render", "write"), keys(scene, "seconds"));
    assertEquals(Set.of("camera", "reflection", "refraction", "shadow"), keys(scene, "rays"));
    assertEquals(Set.of("min", "mean", "max"), keys(scene, "samples"));
    assertEquals(Set.of("estimate", "target", "truncation", "unit"), keys(scene, "error"));
    JsonObject error = scene.getAsJsonObject("error");
    assertEquals(1, error.get("target").getAsDouble());
    assertTrue(error.get("estimate").getAsDouble() <= 1);
    assertTrue(error.get("estimate").getAsDouble() >= error.get("truncation").getAsDouble());
    assertEquals("levels", scene.getAsJsonObject("error").get("unit").getAsString());
    assertTrue(scene.getAsJsonObject("depth").get("max").getAsInt() > 1);
    assertEquals(2, scene.get("primitives").getAsInt());
    assertEquals(0, scene.get("invalid").getAsInt());
    assertTrue(scene.has("clipped"));
    assertTrue(scene.get("sha256").getAsString().matches("[0-9a-f]{64}"));
  }

  @Test
  void theImageIsTheSameWhateverThreadsAndTiles() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    String expected = null;
    for (int threads : new int[] {1, 2, 5}) {
      for (int tile : new int[] {7, 32, 64}) {
        Path folder = dir.resolve("out-" + threads + "-" + tile);
        Path stats = dir.resolve("stats.json");
        Run run =
            Run.of(
                "render",
                a,
                "--out",
                folder,
                "--threads",
                threads,
                "--tile",
                tile,
                "--size",
                "90x70",
                "--samples",
                4,
                "--format",
                "both",
                "--stats",
                stats);
        assertEquals(0, run.exitCode(), run.err());
        String all = scene(stats, 0).get("sha256").getAsString() + Run.digests(folder);
        expected = expected == null ? all : expected;
        assertEquals(expected, all, threads + " threads, tiles of " + tile);
      }
    }
  }

  @Test
  void optionsThatChangeTheImageDoSo() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    String[][] options = {
      {}, {"--seed", "1"}, {"--depth", "0"}, {"--samples", "5"}, {"--samples", "1"}
    };
    Set<String> hashes = new java.util.HashSet<>();
    for (String[] option : options) {
      Path stats = dir.resolve("stats.json");
      Object[] args = {"render", a, "--out", out(), "--stats", stats};
      Object[] all = new Object[args.length + option.length];
      System.arraycopy(args, 0, all, 0, args.length);
      System.arraycopy(option, 0, all, args.length, option.length);
      assertEquals(0, Run.of(all).exitCode());
      hashes.add(scene(stats, 0).get("sha256").getAsString());
    }
    assertEquals(options.length, hashes.size());
  }

  @Test
  void sceneChoosesAndAnUnknownOneListsTheKnown() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "cornell", "glass ball", "third");
    Run run = Run.of("render", a, "--out", out(), "--scene", "third", "--scene", "glass ball");
    assertEquals(0, run.exitCode(), run.err());
    assertEquals(List.of("glass ball.png", "third.png"), Run.list(out()));
    run = Run.of("render", a, "--out", dir.resolve("none"), "--scene", "cornel");
    assertEquals(2, run.exitCode());
    assertTrue(run.err().contains("no scene is called 'cornel'; did you mean 'cornell'?"));
    assertTrue(run.err().contains("The scenes are: cornell, glass ball, third"), run.err());
    assertFalse(Files.exists(dir.resolve("none")));
  }

  @Test
  void equalNamesAreAnErrorBeforeAnythingIsRendered() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "first", "same");
    for (String name : List.of("same", "SAME")) {
      Path b = Scenes.write(dir.resolve("b.yaml"), name, "last");
      Run run = Run.of("render", a, b, "--out", out());
      assertEquals(1, run.exitCode());
      assertEquals(1, run.errLines().size(), run.err());
      assertTrue(run.err().contains("a.yaml") && run.err().contains("b.yaml"), run.err());
      assertFalse(Files.exists(out()));
      run = Run.of("render", a, b, "--out", out(), "--scene", "first", "--scene", "last");
      assertEquals(0, run.exitCode(), "those that are not asked for do no harm: " + run.err());
      Files.delete(out().resolve("first.png"));
      Files.delete(out().resolve("last.png"));
      Files.delete(out());
    }
  }

  @Test
  void filesOfTwoScenesNeverCollide() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "ball", "ball.depth");
    Run run = Run.of("render", a, "--out", out(), "--format", "both", "--aov", "depth");
    assertEquals(1, run.exitCode());
    assertTrue(run.err().contains("would both become ball.depth.pfm"), run.err());
    assertFalse(Files.exists(out()));
    assertEquals(0, Run.of("render", a, "--out", out(), "--aov", "depth").exitCode());
  }

  @Test
  void anImageTooLargeForMemoryIsRefusedWithFigures() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    Run run = Run.of("render", a, "--out", out(), "--size", "26000x26000");
    assertEquals(1, run.exitCode());
    assertTrue(
        run.errLines().get(0).matches("one: an image of 26000x26000 needs \\d+ MiB, but Java .*"));
    assertEquals(List.of(), Run.list(out()));
  }

  @Test
  void everyLineIsTheSameUnderAnyLocale() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(new Locale("ar", "EG"));
      Run run = Run.of("render", a, "--out", out(), "--size", "1000x10");
      assertTrue(
          run.err()
              .matches("(?s)one: 1000x10, [0-9.]+ samples, error [0-9.]+ levels, [0-9.]+ s, .*"),
          run.err());
      assertEquals(0, Run.of("plan", a).exitCode());
    } finally {
      Locale.setDefault(before);
    }
  }

  private static Set<String> keys(JsonObject scene, String part) {
    return scene.getAsJsonObject(part).keySet();
  }

  private static JsonObject scene(Path stats, int index) throws IOException {
    JsonObject json = JsonParser.parseString(Files.readString(stats)).getAsJsonObject();
    return json.getAsJsonArray("scenes").get(index).getAsJsonObject();
  }
}
