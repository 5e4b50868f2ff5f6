package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A turntable's frames are pictures of their own, in every command that makes pictures. */
class TurntableFilesTest {

  @TempDir private Path dir;

  private Path file;
  private Path out;

  @BeforeEach
  void write() throws IOException {
    file = Scenes.write(dir.resolve("a.yaml"), "still", "top");
    Files.writeString(file, Files.readString(file) + "    turntable: {frames: 3}\n");
    out = dir.resolve("out");
  }

  private Run render(int exitCode, String... options) {
    List<Object> args = new ArrayList<>(List.of("render", file, "--out", out, "--samples", 1));
    Collections.addAll(args, (Object[]) options);
    Run run = Run.of(args.toArray());
    assertEquals(exitCode, run.exitCode(), run.err());
    return run;
  }

  private static List<String> frames(int... numbers) {
    List<String> names = new ArrayList<>();
    for (int number : numbers) {
      names.add("top.000" + number + ".png");
    }
    return names;
  }

  @Test
  void everyFrameIsAFileAndHasItsOwnStatistics() throws IOException {
    Path stats = dir.resolve("stats.json");
    render(0, "--scene", "top", "--aov", "id", "--format", "both", "--stats", stats.toString());
    List<String> expected = new ArrayList<>();
    for (int i = 1; i <= 3; i++) {
      Collections.addAll(expected, "top.000" + i + ".id.pfm", "top.000" + i + ".pfm");
      expected.addAll(frames(i));
    }
    assertEquals(expected, Run.list(out));
    JsonArray scenes =
        JsonParser.parseString(Files.readString(stats)).getAsJsonObject().getAsJsonArray("scenes");
    assertEquals(3, scenes.size());
    for (int i = 0; i < 3; i++) {
      JsonObject scene = scenes.get(i).getAsJsonObject();
      assertEquals("top.000" + (i + 1), scene.get("name").getAsString());
      assertTrue(scene.getAsJsonObject("error").has("estimate"));
    }
    Map<String, String> pictures = Run.digests(out);
    assertNotEquals(pictures.get("top.0001.pfm"), pictures.get("top.0002.pfm"));
    assertNotEquals(pictures.get("top.0002.pfm"), pictures.get("top.0003.pfm"));
  }

  @Test
  void resumeGoesOnAfterTheLastFrame() throws IOException {
    render(0);
    assertEquals(
        List.of("still.png", "top.0001.png", "top.0002.png", "top.0003.png"), Run.list(out));
    Map<String, String> before = Run.digests(out);
    Files.delete(out.resolve("top.0002.png"));
    Files.delete(out.resolve("top.0003.png"));
    Run run = render(0, "--resume");
    assertEquals(2, run.errLines().stream().filter(line -> line.contains(": kept ")).count());
    assertEquals(before, Run.digests(out));
  }

  @Test
  void aFrameHasAName() throws IOException {
    render(0, "--scene", "top.0002", "--scene", "top.0003");
    assertEquals(frames(2, 3), Run.list(out));
    Run run = render(2, "--scene", "top.0004");
    assertTrue(run.err().contains("no scene is called 'top.0004'"), run.err());
    Run all = Run.of("replay", file, "--scene", "top", "--pixel", "20,15");
    Run first = Run.of("replay", file, "--scene", "top.0001", "--pixel", "20,15");
    Run second = Run.of("replay", file, "--scene", "top.0002", "--pixel", "20,15");
    assertTrue(first.out().startsWith("top.0001: pixel 20,15 of 40x30"), first.out());
    assertEquals(all.out().replace("top:", "top.0001:"), first.out());
    assertNotEquals(first.out().replace("0001", "0002"), second.out());
  }

  @Test
  void aSceneOfAFramesNameIsAnError() throws IOException {
    String text = Files.readString(file).replace("  still:", "  TOP.0002:");
    Files.writeString(file, text);
    Run run = render(1);
    assertTrue(run.err().contains("would both become top.0002.png"), run.err());
    assertEquals(List.of(), Run.list(out));
  }

  @Test
  void planAndCheckCountScenes() {
    Run plan = Run.of("plan", file, "--scene", "top");
    assertTrue(plan.out().startsWith("top: 40x30, 3 frames, 2 primitives"), plan.out());
    assertTrue(Run.of("check", file).out().endsWith(": 2 scenes, no problems\n"));
  }
}
