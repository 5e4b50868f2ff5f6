package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Damaged files never make a reader throw or hang, and always say in one line what is wrong. */
@Timeout(value = 5, unit = TimeUnit.MINUTES) // a hang, not a speed
class ReaderFuzzTest {

  private static final int ROUNDS = 2000;

  private static final String[] BAITS = {
    "&a ",
    "*a",
    "<<: *a",
    "[",
    "]",
    "{",
    "}",
    ": ",
    "- ",
    "? ",
    "\t",
    "\n",
    "\r",
    "\0",
    "#",
    "\"",
    "'",
    "|",
    ">",
    "!",
    "!!float ",
    "%YAML 1.1\n---\n",
    "---\n",
    "...\n",
    "1e999",
    "-1",
    ".nan",
    ".inf",
    "0x10",
    "~",
    "yes",
    "\u2028",
    "\uFEFF",
    "ü",
    "\uD83D\uDE00",
    "99999999999999999999",
    "[[[[[[[[[[",
    "{a: {a: {a: ",
    "&b [*b]",
    "\\U",
    "transparency",
    "sphere",
    "NaN",
    "PopMatrix\n",
  };

  @Test
  void yaml() {
    fuzz(Resources.text("everything.yaml"), "f.yaml", 20131);
    fuzz(SceneFormatDocTest.example(), "f.yaml", 20132);
  }

  @Test
  void cs315() {
    String text =
        """
        Camera 0 0 40  0 1 0  0 0 9.9  36.5 1
        Output 512 512 CornellBox.png
        BounceDepth 1
        ShadowBias 0.005
        AmbientLight 0.05 0.05 0.05
        PushMatrix
        Rotate 10 20 30
        PointLight 0 9 0  1 1 1
        DirectionalLight 0 -1 0  1 1 1
        Material 1 1 1  0.8 0.8 0.8  0 0 0  0 0 0  0
        Translate 1 2 3
        Scale 1 2 1
        Triangle -10 -10 10  10 -10 -10  -10 -10 -10
        PopMatrix
        Sphere 5 -6 1 4
        """;
    fuzz(text, "f.txt", 20133);
  }

  private static void fuzz(String good, String fileName, long seed) {
    assertEquals(List.of(), Resources.read(good, fileName).problems());
    int bad = 0;
    for (int round = 0; round < ROUNDS; round++) {
      byte[] bytes = damage(good, new Random(seed + 1_000_003L * round));
      try {
        bad += check(bytes, fileName) ? 0 : 1;
      } catch (RuntimeException | StackOverflowError e) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        throw new AssertionError("seed " + seed + ", round " + round + ":\n" + text, e);
      }
    }
    // Most damage must be seen, or this test would damage too little.
    assertTrue(bad > ROUNDS / 2, "only " + bad + " bad files");
  }

  /** Returns whether the file was good. */
  private static boolean check(byte[] bytes, String fileName) {
    SceneFile file = Resources.read(bytes, fileName);
    assertTrue(file.problems().size() <= Problems.MOST + 1);
    assertTrue(!(file.problems().isEmpty() && file.scenes().isEmpty()));
    List<Problem> all = new ArrayList<>(file.problems());
    all.addAll(file.notes());
    for (Problem problem : all) {
      String line = problem.toString();
      assertTrue(line.length() < 600 && line.indexOf('\n') < 0 && line.indexOf('\r') < 0, line);
      assertTrue(problem.line() >= 0 && problem.line() <= 1 + bytes.length, line);
      assertTrue(problem.line() == 0 || problem.column() >= 1, line);
    }
    return file.problems().isEmpty();
  }

  private static byte[] damage(String good, Random random) {
    StringBuilder text = new StringBuilder(good);
    int times = 1 + random.nextInt(4);
    for (int i = 0; i < times && text.length() > 0; i++) {
      int from = random.nextInt(text.length());
      int to = Math.min(text.length(), from + 1 + random.nextInt(12));
      switch (random.nextInt(6)) {
        case 0 -> text.delete(from, to);
        case 1 -> text.insert(from, BAITS[random.nextInt(BAITS.length)]);
        case 2 -> text.replace(from, to, BAITS[random.nextInt(BAITS.length)]);
        case 3 -> text.insert(random.nextInt(text.length()), text.substring(from, to));
        case 4 -> text.setCharAt(from, (char) (1 + random.nextInt(300)));
        default -> text.setLength(Math.max(1, random.nextInt(20) == 0 ? from : text.length()));
      }
    }
    byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
    if (random.nextInt(20) == 0 && bytes.length > 0) {
      bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
    }
    return bytes;
  }
}
