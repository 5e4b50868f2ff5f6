package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.geometry.MeshFacts;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Damaged models never make the reader throw or hang, and always say in one line what is wrong. */
@Timeout(value = 5, unit = TimeUnit.MINUTES) // a hang, not a speed
class ObjFuzzTest {

  private static final int ROUNDS = 3000;

  private static final String GOOD =
      """
      # a bit of everything
      mtllib a.mtl
      o thing
      v 0 0 0
      v 1.5 -2.5e-1 .25 1.0
      v 1 1 0 0.5 0.5 0.5
      v 0 1 1e-3
      v 2 2 2
      vt 0 0
      vn 0 0 1
      usemtl red
      s 1
      f 1 2 3
      f 1/1 2/1 3/1 4/1
      f 1//1 2//1 \\
        3//1
      f -5/-1/-1 -4/-1/-1 -3/-1/-1 -2/-1/-1 -1/-1/-1 # five
      p 1
      l 1 2
      f 1 3 2 4 5 3
      """;

  private static final String[] BAITS = {
    "f ",
    "v ",
    "\n",
    "\r",
    "\r\n",
    "\\\n",
    "\\",
    "#",
    "/",
    "//",
    "-",
    "+",
    ".",
    ",",
    "e",
    "e999",
    "nan",
    "inf",
    "1.#INF",
    "0",
    "-1",
    "-6",
    "99",
    "2147483648",
    "-2147483649",
    "1e308",
    "1e-400",
    "\0",
    "\u001A",
    "\t",
    "\f",
    "\u00A0",
    "ü",
    "\uFEFF",
    "\uD83D\uDE00",
    "v 1e200 0 0\n",
    "f 1 2 3 4 5 4 3 2\n",
    "f 1 1 1 1\n",
    "f 7 8 9\n",
    "curv 0 1\n",
    "vn\n",
    "0.00000000000000000001"
  };

  @Test
  void damagedModels() {
    assertEquals(List.of(), ObjText.read(GOOD).problems());
    int bad = 0;
    for (int round = 0; round < ROUNDS; round++) {
      byte[] bytes = damage(new Random(20141 + 1_000_003L * round));
      try {
        bad += check(bytes) ? 0 : 1;
      } catch (RuntimeException | StackOverflowError e) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        throw new AssertionError("round " + round + ":\n" + text, e);
      }
    }
    // Much damage must be seen, or this test would damage too little.
    assertTrue(bad > ROUNDS / 3, "only " + bad + " bad files");
  }

  /** Returns whether the file was good. */
  private static boolean check(byte[] bytes) {
    ObjModel model = ObjText.read(bytes);
    List<Problem> all = new ArrayList<>(model.problems());
    all.addAll(model.notes());
    assertTrue(all.size() <= 11, all.toString());
    for (Problem problem : all) {
      String line = problem.toString();
      assertTrue(line.length() < 600 && line.indexOf('\n') < 0 && line.indexOf('\r') < 0, line);
      assertTrue(problem.line() >= 0 && problem.line() <= 1 + bytes.length, line);
      assertTrue(problem.line() == 0 || problem.column() >= 1, line);
      assertTrue(problem.column() <= 1 + bytes.length, line);
    }
    assertEquals(model.problems().isEmpty(), model.mesh() != null);
    if (model.mesh() != null) {
      assertTrue(model.mesh().triangles() <= bytes.length);
      assertTrue(MeshFacts.area(model.mesh()) >= 0);
    }
    return model.problems().isEmpty();
  }

  private static byte[] damage(Random random) {
    StringBuilder text = new StringBuilder(GOOD);
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
        default -> text.setLength(random.nextInt(20) == 0 ? from : text.length());
      }
    }
    boolean wide = random.nextInt(20) == 0;
    String marked = wide ? "\uFEFF" + text : text.toString();
    byte[] bytes = marked.getBytes(wide ? StandardCharsets.UTF_16LE : StandardCharsets.UTF_8);
    if (random.nextInt(20) == 0 && bytes.length > 0) {
      bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
    }
    return bytes;
  }

  /** Files that ask for much in few bytes. */
  @Test
  void hostileSizes() {
    assertEquals(1, ObjText.read("f 1 2 3 999999999\n").problems().size());
    StringBuilder face = new StringBuilder("v 0 0 0\nv 1 0 0\nv 1 1 0\nf");
    for (int i = 0; i < 300_000; i++) {
      face.append(i % 3 == 0 ? " 1" : i % 3 == 1 ? " 2" : " 3");
    }
    assertEquals(299_998, ObjText.mesh(face.toString()).triangles());
    StringBuilder names = new StringBuilder();
    for (int i = 0; i < 200_000; i++) {
      names.append("x").append(i).append('\n');
    }
    assertEquals(2, ObjText.notes(names.toString()).size());
  }
}
