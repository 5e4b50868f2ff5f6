package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import glint.geometry.MeshFacts;
import glint.math.Vector3d;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What OBJ files may be as bytes. */
class ObjBytesTest {

  private static final String FOUR = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  private static final List<Vector3d> TRIANGLE = List.of(v(0, 0, 0), v(1, 0, 0), v(1, 1, 0));

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-8", "UTF-16LE", "UTF-16BE"})
  void encodings(String charset) {
    Charset encoding = Charset.forName(charset);
    String text = "\uFEFFo Würfel \uD83D\uDE00\n" + FOUR + "usemtl \u4E2D\nf 1 2 3\n";
    assertEquals(TRIANGLE, ObjText.corners(ObjText.mesh(text.getBytes(encoding))));
    String bad = "\uFEFF" + FOUR + "\n  v 1 q 2";
    List<Problem> problems = ObjText.read(bad.getBytes(encoding)).problems();
    assertEquals("m.obj:6:7: expected a number, but found 'q'", problems.get(0).toString());
  }

  @Test
  void encodingsDoNotDependOnBlocks() {
    StringBuilder text = new StringBuilder("\uFEFF#");
    for (int i = 0; i < 9000; i++) {
      text.append(i % 7 == 0 ? "x" : "\uD83D\uDE00");
    }
    text.append('\n').append(FOUR).append("f 1 2 3\n");
    byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_16LE);
    assertEquals(TRIANGLE, ObjText.corners(ObjText.mesh(bytes)));
  }

  @Test
  void binaryFilesAreRefusedAtOnce() {
    byte[] png = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 13};
    assertEquals(
        "m.obj:2:1: holds a control character (0x1A): not a text file?",
        ObjText.read(png).problems().get(0).toString());
    byte[] wide = "v 0 0 0\n".getBytes(StandardCharsets.UTF_16LE);
    assertEquals(
        List.of("m.obj:1:1: holds a control character (0x00): not a text file?"),
        List.of(ObjText.read(wide).problems().get(0).toString()));
  }

  @Test
  void longTokensAreRefusedAndLongLinesAreNot() {
    String zeros = "0".repeat(900);
    assertEquals(TRIANGLE, ObjText.corners(FOUR + "f " + zeros + "1 2 3\n"));
    String longer = "0".repeat(200_000);
    for (String text : List.of("v 1." + longer + " 0 0\n", "f " + longer + "1 2 3\n")) {
      assertEquals(
          List.of("5:3: longer than 1024 characters: not a number"), ObjText.problems(FOUR + text));
    }
    String blanks = " ".repeat(200_000);
    String text =
        FOUR + "f" + blanks + "1" + blanks + "2" + blanks + "\\\n" + blanks + "3" + blanks;
    assertEquals(TRIANGLE, ObjText.corners(text));
    assertEquals(TRIANGLE, ObjText.corners(FOUR + "#" + longer + "\nf 1 2 3 #" + longer));
    assertEquals(
        List.of("5:200003: expected a number, but found 'q'"),
        ObjText.problems(FOUR + "v " + blanks + "q"));
  }

  /** What is read must not depend on how the stream hands out its bytes. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 1023, 1024, 1025, 65535, 65536, 65537})
  void anyBlocksOfBytes(int block) throws IOException {
    StringBuilder text = new StringBuilder("\uFEFF");
    for (int i = 0; i < 6000; i++) {
      text.append("v ").append(i * 0.37).append(" -1.25e-2 ").append(i).append(" \r\n");
    }
    for (int i = 3; i <= 6000; i++) {
      text.append("f ").append(i).append("//1 \\\r\n -1 ").append(i - 2).append(" # c\r\n");
    }
    byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
    InputStream slow =
        new ByteArrayInputStream(bytes) {
          @Override
          public synchronized int read(byte[] to, int from, int most) {
            return super.read(to, from, Math.min(most, block));
          }
        };
    ObjModel model = ObjReader.read(slow, "m.obj");
    assertEquals(ObjText.corners(ObjText.mesh(bytes)), ObjText.corners(model.mesh()));
    assertEquals(5997, model.mesh().triangles());
    Vector3d first = MeshFacts.corners(model.mesh(), 0).get(0);
    assertEquals(v(2 * 0.37, -0.0125, 2), first);
  }

  @Test
  void theStreamsOwnFailureIsNotOurs() {
    InputStream broken =
        new ByteArrayInputStream(new byte[0]) {
          @Override
          public synchronized int read(byte[] to, int from, int most) {
            throw new UncheckedIOException(new IOException("disk on fire"));
          }
        };
    assertThrows(UncheckedIOException.class, () -> ObjReader.read(broken, "m.obj"));
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
