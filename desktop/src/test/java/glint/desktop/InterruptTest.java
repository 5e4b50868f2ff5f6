package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The command as a process of its own, stopped by a signal in the middle of a batch. */
@Timeout(120)
class InterruptTest {

  private static final int SCENES = 12;

  /** A build in the background ignores SIGINT, and so would its children. */
  private static final List<String> RESET = resetSignals();

  @TempDir private Path dir;

  private Path file;

  @BeforeEach
  void writeScenes() throws IOException {
    String[] names = IntStream.range(10, 10 + SCENES).mapToObj(i -> "s" + i).toArray(String[]::new);
    file = Scenes.write(dir.resolve("many.yaml"), names);
  }

  @ParameterizedTest
  @CsvSource({"INT, 130", "TERM, 143"})
  void anInterruptedBatchContinuesToTheSameFiles(String signal, int exitCode) throws Exception {
    assumeTrue(!signal.equals("INT") || !RESET.isEmpty(), "the build may ignore SIGINT");
    Path whole = dir.resolve("whole");
    assertEquals(0, start(whole, "--samples", "32").waitFor());

    Path out = dir.resolve("out");
    Process process = start(out, "--samples", "32");
    while (Run.list(out).stream().filter(name -> name.endsWith(".png")).count() < 2) {
      assertTrue(process.isAlive(), "the batch ended early");
      Thread.sleep(1);
    }
    assertTrue(kill(signal, process));
    assertEquals(exitCode, process.waitFor());

    int finished = assertWhole(out, whole);
    assertTrue(finished >= 2 && finished < SCENES, finished + " scenes are finished");
    String expected =
        "interrupted: " + finished + " of " + SCENES + " scenes are finished; --resume continues";
    String output = output(process);
    assertTrue(output.endsWith(expected + System.lineSeparator()), output);
    JsonObject stats = JsonParser.parseString(Files.readString(stats(out))).getAsJsonObject();
    assertTrue(stats.get("interrupted").getAsBoolean());
    assertEquals(finished, stats.getAsJsonArray("scenes").size());

    Process rest = start(out, "--samples", "32", "--resume");
    assertEquals(0, rest.waitFor());
    assertEquals(finished, output(rest).lines().filter(l -> l.contains(": kept ")).count());
    assertEquals(Run.digests(whole), Run.digests(out));
  }

  @Test
  void aLongSceneIsGivenUpInTheMiddle() throws Exception {
    Path out = dir.resolve("out");
    Process process = start(out, "--samples", "10000000");
    while (!Files.exists(out)) {
      assertTrue(process.isAlive(), "the batch ended early");
      Thread.sleep(1);
    }
    // The folder is made just before the first ray; a longer wait could not make this test fail
    Thread.sleep(1000);
    assertTrue(kill("TERM", process));
    assertEquals(143, process.waitFor());
    assertEquals(List.of(), Run.list(out));
    assertTrue(output(process).startsWith("interrupted: 0 of " + SCENES), "gave up waiting");
    assertTrue(Files.exists(stats(out)));
  }

  @Test
  void exitCodesOfTheProcess() throws Exception {
    assertEquals(1, glint().waitFor());
    assertEquals(2, glint("render").waitFor());
    assertEquals(1, glint("check", "nowhere.yaml").waitFor());
    assertEquals(0, glint("check", file.toString()).waitFor());
  }

  /** Counts the scenes that are there, all files of each, and checks that nothing else is. */
  private static int assertWhole(Path out, Path whole) throws IOException {
    Map<String, String> expected = Run.digests(whole);
    Map<String, String> actual = Run.digests(out);
    assertTrue(expected.entrySet().containsAll(actual.entrySet()), "torn: " + actual.keySet());
    assertEquals(0, actual.size() % 3, "incomplete: " + actual.keySet());
    return actual.size() / 3;
  }

  private Process start(Path out, String... more) throws IOException {
    List<String> words = new ArrayList<>(List.of("render", file.toString(), "--out"));
    words.addAll(List.of(out.toString(), "--format", "both", "--aov", "normal"));
    words.addAll(List.of("--size", "160x120"));
    words.addAll(List.of("--stats", stats(out).toString()));
    words.addAll(List.of(more));
    return glint(words.toArray(String[]::new));
  }

  private static Path stats(Path out) {
    return out.resolveSibling(out.getFileName() + ".json");
  }

  private Process glint(String... args) throws IOException {
    List<String> words = new ArrayList<>(RESET);
    words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    words.add("-Djava.awt.headless=true");
    words.addAll(List.of("-cp", System.getProperty("java.class.path"), Main.class.getName()));
    words.addAll(List.of(args));
    return new ProcessBuilder(words).directory(dir.toFile()).redirectErrorStream(true).start();
  }

  private static String output(Process process) throws IOException {
    return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }

  private static boolean kill(String signal, Process process) {
    return succeeds("sh", "-c", "kill -" + signal + " " + process.pid());
  }

  private static List<String> resetSignals() {
    List<String> reset = List.of("env", "--default-signal=INT");
    return succeeds("env", "--default-signal=INT", "true") ? reset : List.of();
  }

  private static boolean succeeds(String... command) {
    try {
      Process process = new ProcessBuilder(command).start();
      return process.waitFor(10, TimeUnit.SECONDS) && process.exitValue() == 0;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
