package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.image.Image;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReplayCommandTest {

  private static final String COLOR = "\\(([^,]+), ([^,]+), ([^)]+)\\)";

  @TempDir private Path dir;

  /** Returns the numbers of a line that a pattern finds. */
  private static double[] numbers(Run run, String pattern) {
    Matcher matcher = Pattern.compile(pattern).matcher(run.out());
    assertTrue(matcher.find(), run.out() + run.err());
    double[] numbers = new double[matcher.groupCount()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = Double.parseDouble(matcher.group(i + 1));
    }
    return numbers;
  }

  @Test
  void thePixelIsThatOfARenderWithTheSameOptions() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    Object[] options = {"--size", "20x15", "--samples", "5", "--seed", "3", "--depth", "1"};
    Run render = run(options, "render", file, "--format", "pfm", "--quiet", "--out", dir);
    assertEquals(new Run(0, "", ""), render);
    Image image = ImageFiles.read(dir.resolve("two.pfm"), glint.color.Transfer.SRGB);
    Run replay = run(options, "replay", file, "--scene", "two", "--pixel", "10,8");
    assertEquals(0, replay.exitCode(), replay.err());
    assertTrue(
        replay.out().startsWith("two: pixel 10,8 of 20x15\nmean of 5 samples ("), replay.out());
    double[] mean = numbers(replay, "mean of 5 samples " + COLOR);
    for (int c = 0; c < 3; c++) {
      assertEquals(image.rgb()[3 * (8 * 20 + 10) + c], (float) mean[c]);
    }
    // The tree is that of the sample which its line tells.
    double[] shown =
        numbers(replay, "\nsample (\\d+), at (\\S+), (\\S+) in the pixel, the farthest");
    double[] listed = numbers(replay, "\n +" + (int) shown[0] + " +\\d+ +" + COLOR);
    double[] sum = numbers(replay, "\n(\\d+) rays add up to " + COLOR);
    for (int c = 0; c < 3; c++) {
      assertEquals(listed[c], sum[c + 1]);
    }
    assertTrue(replay.out().contains("(sphere of mirror, line 18)"), replay.out());
  }

  @Test
  void theTourShowsWhatThisVersionPrints() throws IOException {
    Path file = Path.of("..", "scenes", "cs315", "mirrors.txt");
    Run run = Run.of("replay", file, "--pixel", "280,280", "--samples", "1");
    String command = "    ./glint replay scenes/cs315/mirrors.txt --pixel 280,280 --samples 1\n\n";
    String block = run.out().replaceAll("\\R", "\n").replaceAll("(?m)^(?=.)", "    ");
    String tour = Files.readString(Path.of("..", "docs", "tour.md"));
    assertTrue(tour.contains(command + block), command + block);
  }

  @Test
  void aRenderWithInvalidSamplesSaysHowToSeeOne() throws IOException {
    Path file = dir.resolve("it's bright.yaml");
    Files.writeString(
        file,
        """
        scenes:
          two suns:
            image: {width: 8, height: 6}
            camera: {position: [0, 0, 0], look_at: [0, 1, -9], fov: 40}
            surfaces:
              - plane: {point: [0, -1, 0], normal: [0, 1, 0], material: {emission: 1e308, reflection: 1}}
              - plane: {point: [0, 1, 0], normal: [0, 1, 0], material: {emission: 1e308, reflection: 1}}
        """);
    Run render = Run.of("render", file, "--out", dir, "--samples", "3", "--depth", "3");
    assertEquals(0, render.exitCode(), render.err());
    String quoted = "'" + file.toString().replace("'", "'\\''") + "'";
    String line =
        "see one: glint replay " + quoted + " --scene 'two suns' --pixel 0,0 --samples 3 --depth 3";
    assertTrue(render.errLines().contains(line), render.err());
    Run replay = Run.of("replay", file, "--pixel", "0,0", "--samples", "3", "--depth", "3");
    assertTrue(replay.out().contains("3 samples not finite and left out"), replay.out());
    Path good = Scenes.write(dir.resolve("good.yaml"), "one");
    assertFalse(Run.of("render", good, "--out", dir).err().contains("replay"));
  }

  private static Run run(Object[] options, Object... words) {
    Object[] all = java.util.Arrays.copyOf(words, words.length + options.length);
    System.arraycopy(options, 0, all, words.length, options.length);
    return Run.of(all);
  }

  @Test
  void oneSampleIsShownAlone() throws IOException {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    Run third = Run.of("replay", file, "--pixel", "20,15", "--sample", "3");
    assertEquals(0, third.exitCode(), third.err());
    assertTrue(third.out().contains("\nsample 3, at "), third.out());
    assertFalse(third.out().contains("farthest"), third.out());
    Run centre = Run.of("replay", file, "--pixel", "20,15", "--samples", "1");
    assertTrue(centre.out().contains("\nsample 0, at 0.5000, 0.5000 in the pixel\n"), centre.out());
    Run many = Run.of("replay", file, "--pixel", "20,15", "--samples", "100");
    assertTrue(many.out().contains("the 16 samples that are farthest"), many.out());
    assertEquals(18, many.out().split("\nsample")[0].lines().skip(3).count(), many.out());
  }

  @Test
  void whatIsNotThereIsSaid() throws IOException {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    assertUsage("Missing required option: '--pixel", "replay", file);
    assertUsage("--pixel must be column,row", "replay", file, "--pixel", "1;2");
    assertUsage(
        "--pixel 40,0 is outside of the image, which has 40x30 pixels",
        "replay",
        file,
        "--scene",
        "one",
        "--pixel",
        "40,0");
    assertUsage("--scene must name one of the scenes: one, two", "replay", file, "--pixel", "1,2");
    assertUsage("did you mean 'two'?", "replay", file, "--scene", "tow", "--pixel", "1,2");
    assertUsage(
        "--sample must be 0 to 15, but is 16",
        "replay",
        file,
        "--scene",
        "one",
        "--pixel",
        "1,2",
        "--sample",
        "16");
    Run missing = Run.of("replay", dir.resolve("nowhere.yaml"), "--pixel", "1,2");
    assertEquals(1, missing.exitCode());
    assertEquals(1, missing.errLines().size());
    // A scene that is sound is traced, but that another is not makes the run fail.
    Path half = dir.resolve("half.yaml");
    Files.writeString(half, Files.readString(file).replace("center: [0.125", "center: [x"));
    Run run = Run.of("replay", half, "--pixel", "1,2");
    assertEquals(1, run.exitCode());
    assertTrue(run.out().startsWith("one: pixel 1,2"), run.out());
    assertTrue(run.err().startsWith(half + ":"), run.err());
  }

  private static void assertUsage(String message, Object... words) {
    Run run = Run.of(words);
    assertEquals(2, run.exitCode());
    assertEquals("", run.out());
    assertTrue(run.err().contains(message), run.err());
    assertEquals(
        List.of("Try 'glint replay --help'."),
        run.errLines().subList(run.errLines().size() - 1, run.errLines().size()));
  }
}
