package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReportCommandTest {

  private static final List<String> FILES =
      List.of(
          "speed-and-error-rays.svg",
          "speed-and-error-reliability.svg",
          "speed-and-error-seconds.svg",
          "speed-and-error.html",
          "speed-and-error.json",
          "speed-and-error.md");

  @TempDir private Path dir;

  private Path out() {
    return dir.resolve("out");
  }

  private Run report(Object... words) {
    Object[] all = new Object[words.length + 9];
    List<Object> fixed =
        List.of("report", "--out", out(), "--size", "8x6", "--samples", 4, "--time-limit", "0.5s");
    for (int i = 0; i < all.length; i++) {
      all[i] = i < fixed.size() ? fixed.get(i) : words[i - fixed.size()];
    }
    return Run.of(all);
  }

  private JsonObject json() throws IOException {
    String json = Files.readString(out().resolve("speed-and-error.json"));
    return JsonParser.parseString(json).getAsJsonObject();
  }

  private JsonArray scenes() throws IOException {
    return json().getAsJsonArray("scenes");
  }

  @Test
  void everySceneIsMeasured() throws IOException {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    Run run = report(file, "--threads", 1);
    assertEquals(0, run.exitCode(), run.err());
    assertEquals(FILES, Run.list(out()));
    assertTrue(run.err().contains("one: error "), run.err());
    String command = json().get("command").getAsString();
    assertTrue(
        command.startsWith("glint report --out ") && command.endsWith("--threads 1"), command);
    assertEquals(1, json().getAsJsonObject("environment").get("threads").getAsInt());
    assertEquals(2, scenes().size());
    JsonObject one = scenes().get(0).getAsJsonObject();
    assertEquals("one", one.get("name").getAsString());
    assertEquals(8, one.get("width").getAsInt());
    JsonArray points = one.getAsJsonObject("uniform").getAsJsonArray("points");
    double camera = 8 * 6;
    for (int i = 0; i < points.size(); i++) {
      JsonObject point = points.get(i).getAsJsonObject();
      assertEquals(1 << i, point.get("samples").getAsInt());
      double rays = point.getAsJsonObject("rays").get("camera").getAsDouble();
      assertEquals(camera * (1 << i), rays);
      assertTrue(point.getAsJsonObject("error").get("levels").getAsDouble() > 0);
    }
    // The image of a single sample is the same for every seed.
    JsonArray runs = points.get(0).getAsJsonObject().getAsJsonArray("runs");
    runs.forEach(levels -> assertEquals(runs.get(0), levels));
  }

  @Test
  void whatASceneSaysOfItsPictureIsTheTruth() throws IOException {
    // The pixel is 0.5 in truth, so that the error is what the scene is wrong by.
    String camera = "camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}\n";
    String answers =
        "expect: [{pixel: [0, 0], value: 0.25, tolerance: 1, depth: 3, samples: 16},"
            + " {pixel: [1, 0], value: 0.25, tolerance: 1, depth: 3, samples: 16}]\n";
    Path file = dir.resolve("a.yaml");
    Files.writeString(
        file,
        "scenes:\n  said:\n    image: {width: 2, height: 1}\n    background: 0.5\n    "
            + camera
            + "    "
            + answers
            + "  seen:\n    background: 0.5\n    "
            + camera);
    Run run = report(file);
    assertEquals(0, run.exitCode(), run.err());
    JsonObject said = scenes().get(0).getAsJsonObject();
    assertEquals(2, said.get("width").getAsInt());
    assertEquals("2 exact pixels", said.getAsJsonObject("truth").get("origin").getAsString());
    JsonObject point =
        said.getAsJsonObject("uniform").getAsJsonArray("points").get(2).getAsJsonObject();
    assertEquals(0.25, point.getAsJsonObject("error").get("linear").getAsDouble(), 1e-15);
    JsonObject seen = scenes().get(1).getAsJsonObject();
    assertEquals(8, seen.get("width").getAsInt());
    String origin = seen.getAsJsonObject("truth").get("origin").getAsString();
    assertEquals("2 × 64 to 16384 samples", origin);
  }

  @Test
  void theCommandsOfTheWorstPixelsShowThem() throws IOException {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    assertEquals(0, report(file, "--seed", 3, "--quiet").exitCode());
    JsonObject one = scenes().get(0).getAsJsonObject();
    assertEquals(4, one.getAsJsonArray("targets").size());
    JsonObject worst = one.getAsJsonArray("worst").get(0).getAsJsonObject();
    String command = worst.get("replay").getAsString();
    assertTrue(command.endsWith(" --size 8x6 --max-error 1 --seed 3"), command);
    Run replay = Run.of((Object[]) command.substring("glint ".length()).split(" "));
    assertEquals(0, replay.exitCode(), replay.err());
    assertTrue(replay.out().contains("claimed to within"), replay.out());
    double claimed = worst.getAsJsonObject("pixel").get("claimed").getAsDouble();
    String within = String.format(Locale.ROOT, "claimed to within %.2g levels", claimed);
    assertTrue(replay.out().contains(within), replay.out());
  }

  @Test
  void onlyTheNamedScenesAreMeasured() throws IOException {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    assertEquals(new Run(0, "", ""), report(file, "--scene", "two", "--quiet"));
    assertEquals(1, scenes().size());
    assertEquals("two", scenes().get(0).getAsJsonObject().get("name").getAsString());
    assertEquals(2, report(file, "--scene", "tow").exitCode());
  }

  @Test
  void whatIsWrongIsSaidAndTheRestIsMeasured() throws IOException {
    Path good = Scenes.write(dir.resolve("good.yaml"), "one");
    Path bad = dir.resolve("bad.yaml");
    Files.writeString(bad, Files.readString(good).replace("radius: 1", "radius: 0"));
    Run run = report(bad, good, "--quiet");
    assertEquals(1, run.exitCode());
    assertEquals(1, run.errLines().size(), run.err());
    assertTrue(run.err().startsWith(bad + ":"), run.err());
    assertEquals(1, scenes().size());
  }

  @Test
  void withoutASceneNothingIsWritten() throws IOException {
    Run run = report(dir.resolve("nowhere.yaml"));
    assertEquals(1, run.exitCode());
    assertEquals(1, run.errLines().size(), run.err());
    assertEquals(List.of(), Run.list(out()));
  }

  @Test
  void scenesOfOneNameCannotBeToldApart() throws IOException {
    Path a = Scenes.write(dir.resolve("a.yaml"), "one");
    Path b = Scenes.write(dir.resolve("b.yaml"), "One");
    Run run = report(a, b);
    assertEquals(1, run.exitCode());
    assertEquals(1, run.errLines().size(), run.err());
    assertTrue(run.err().contains("would both become One"), run.err());
    assertEquals(List.of(), Run.list(out()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"5", "s", "-5s", "0s", "0.0m", "5 s", "1e3s", "5d", "99999999s"})
  void aTimeIsANumberAndItsUnit(String time) throws IOException {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    Run run = Run.of("report", file, "--time-limit", time, "--out", out());
    assertEquals(2, run.exitCode());
    String wrong = "--time-limit must be a time above zero such as 30s, 5m or 1h, but is '" + time;
    assertTrue(run.err().contains(wrong), run.err());
  }

  @Test
  void timesAreInSecondsMinutesOrHours() {
    ReportOptions options = new ReportOptions();
    options.timeLimit("2.5m");
    assertEquals(150, options.timeLimit);
    options.timeLimit("30s");
    assertEquals(30, options.timeLimit);
    options.timeLimit("1h");
    assertEquals(3600, options.timeLimit);
  }

  @Test
  void anInterruptedReportIsNotWritten() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    ReportOptions options = new ReportOptions();
    options.out = out();
    StringWriter err = new StringWriter();
    Reporter reporter = new Reporter(new PrintWriter(err, true), true);
    try (Interrupt interrupt = Interrupt.install()) {
      interrupt.request();
      ReportRun run = new ReportRun(new SceneFilter(), options, reporter, interrupt);
      assertEquals(ExitCode.INTERRUPTED, run.run("glint report", List.of(file)));
    }
    assertEquals("interrupted: no report is written", err.toString().trim());
    assertEquals(List.of(), Run.list(out()));
  }
}
