package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What {@code --resume} keeps, and what it does not. */
class ResumeTest {

  @TempDir private Path dir;

  private Path file;
  private Path out;

  @BeforeEach
  void renderOnce() throws IOException {
    file = Scenes.write(dir.resolve("a.yaml"), "one", "zw\u00f6lf");
    out = dir.resolve("out");
  }

  private Run render(String... options) {
    Object[] args = {"render", file, "--out", out, "--samples", 2};
    Object[] all = Arrays.copyOf(args, args.length + options.length);
    System.arraycopy(options, 0, all, args.length, options.length);
    Run run = Run.of(all);
    assertEquals(0, run.exitCode(), run.err());
    return run;
  }

  private static long kept(Run run) {
    return run.errLines().stream().filter(line -> line.contains(": kept ")).count();
  }

  @Test
  void finishedScenesAreKeptWithTheirStatistics() throws IOException {
    Path stats = dir.resolve("stats.json");
    String[] options = {"--format", "both", "--aov", "id,depth", "--stats", stats.toString()};
    render(options);
    String first = Files.readString(stats);
    Map<String, String> before = Run.digests(out);
    Files.delete(out.resolve("one.png"));
    Run run = render(append(options, "--resume"));
    assertEquals(1, kept(run), run.err());
    assertEquals(before, Run.digests(out));
    run = render(append(options, "--resume"));
    assertEquals(2, kept(run), run.err());
    assertEquals(before, Run.digests(out));
    String again = Files.readString(stats);
    assertTrue(again.contains("\"resumed\": true") && !again.contains("\"resumed\": false"));
    assertEquals(timeless(first), timeless(again));
  }

  private static String timeless(String stats) {
    return stats
        .replaceAll("\"(load|build|render|write)\": [-0-9.E]+", "\"$1\": 0")
        .replaceAll("\"raysPerSecond\": [^,]+", "\"raysPerSecond\": 0")
        .replace("\"resumed\": true", "\"resumed\": false");
  }

  @Test
  void withoutResumeNothingIsKept() {
    render();
    assertEquals(0, kept(render()));
  }

  @Test
  void whateverChangesTheImageRendersItAgain() throws IOException {
    render();
    assertEquals(2, kept(render("--resume")));
    assertEquals(2, kept(render("--resume", "--threads", "3", "--tile", "5")));
    for (String[] other :
        List.of(
            new String[] {"--seed", "1"},
            new String[] {"--depth", "2"},
            new String[] {"--size", "20x15"},
            new String[] {"--format", "both"},
            new String[] {"--aov", "id"})) {
      assertEquals(0, kept(render(append(other, "--resume"))), other[0]);
      assertEquals(2, kept(render(append(other, "--resume"))), other[0]);
      render();
    }
    Files.writeString(file, Files.readString(file).replace("color: 0.1", "color: 0.2"));
    assertEquals(0, kept(render("--resume")), "the scene file has changed");
  }

  @Test
  void aDamagedOrForeignFileIsRenderedAgain() throws IOException {
    String[] options = {"--format", "both", "--resume"};
    render(options);
    Map<String, String> before = Run.digests(out);
    for (String name : List.of("one.png", "one.pfm")) {
      Path image = out.resolve(name);
      byte[] bytes = Files.readAllBytes(image);
      byte[] flipped = bytes.clone();
      flipped[bytes.length / 2] ^= 1;
      byte[][] damaged = {
        {}, Arrays.copyOf(bytes, bytes.length - 1), flipped, Arrays.copyOf(bytes, bytes.length + 1)
      };
      for (byte[] content : damaged) {
        Files.write(image, content);
        assertEquals(1, kept(render(options)), name);
        assertEquals(before, Run.digests(out));
      }
    }
    Files.copy(out.resolve("zw\u00f6lf.png"), dir.resolve("copy.png"));
    Files.delete(out.resolve("one.png"));
    Files.move(dir.resolve("copy.png"), out.resolve("one.png"));
    assertEquals(1, kept(render(options)), "the record is another scene's");
    assertEquals(before, Run.digests(out));
  }

  @Test
  void pfmAloneIsKeptIfItIsWholeAndNewerThanItsScene() throws IOException {
    String[] options = {"--format", "pfm", "--aov", "id", "--resume"};
    FileTime anHourAgo = FileTime.fromMillis(System.currentTimeMillis() - 3_600_000);
    Files.setLastModifiedTime(file, anHourAgo);
    render(options);
    Map<String, String> before = Run.digests(out);
    Run run = render(options);
    assertEquals(2, kept(run));
    assertTrue(run.err().contains("(a PFM holds no record of its options)"), run.err());
    assertEquals(0, kept(render(append(options, "--size", "20x15"))));
    assertEquals(0, kept(render(options)));
    assertEquals(before, Run.digests(out));
    Files.write(out.resolve("one.id.pfm"), new byte[7]);
    assertEquals(1, kept(render(options)));
    Files.setLastModifiedTime(out.resolve("one.pfm"), anHourAgo);
    assertEquals(1, kept(render(options)));
    assertEquals(before, Run.digests(out));
  }

  @Test
  void everyRunWritesTheSameBytes() throws IOException {
    render("--format", "both");
    Map<String, String> before = Run.digests(out);
    render("--format", "both", "--threads", "1");
    assertEquals(before, Run.digests(out));
    String record = PngInfo.read(out.resolve("one.png")).record().orElseThrow();
    assertFalse(record.contains("seconds"), record);
    record = PngInfo.read(out.resolve("zw\u00f6lf.png")).record().orElseThrow();
    assertTrue(record.chars().allMatch(c -> c < 128), record);
    assertEquals("zw\u00f6lf", RunRecord.fromJson(record).orElseThrow().scene().name());
  }

  private static String[] append(String[] options, String... more) {
    String[] all = Arrays.copyOf(options, options.length + more.length);
    System.arraycopy(more, 0, all, options.length, more.length);
    return all;
  }
}
