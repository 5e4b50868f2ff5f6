package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** Reading needs little more than the mesh itself: all that it ever allocates is under three. */
class ObjMemoryTest {

  private static final int SIDE = 300;

  /** A sheet of points on a grid, each square two triangles. */
  private static byte[] grid(boolean smooth) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < SIDE * SIDE; i++) {
      double height = (i * 7919L % 1000) / 1000.0;
      text.append(String.format(Locale.ROOT, "v %d %d %.6f%n", i % SIDE, i / SIDE, height));
      text.append(smooth ? "vn 0.1 0.2 0.9\n" : "");
    }
    for (int i = 0; i + SIDE < SIDE * SIDE; i++) {
      if (i % SIDE + 1 < SIDE) {
        face(text, smooth, i + 1, i + 2, i + SIDE + 2);
        face(text, smooth, i + 1, i + SIDE + 2, i + SIDE + 1);
      }
    }
    return text.toString().getBytes(StandardCharsets.UTF_8);
  }

  private static void face(StringBuilder text, boolean smooth, int... corners) {
    text.append('f');
    for (int c : corners) {
      text.append(' ').append(c).append(smooth ? "//" + c : "");
    }
    text.append('\n');
  }

  private static double allocatedMeshes(boolean smooth) {
    byte[] text = grid(smooth);
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    ObjText.read(text);
    long before = threads.getCurrentThreadAllocatedBytes();
    int triangles = ObjText.read(text).mesh().triangles();
    long bytes = threads.getCurrentThreadAllocatedBytes() - before;
    assertEquals(2 * (SIDE - 1) * (SIDE - 1), triangles);
    double mesh = (24.0 * SIDE * SIDE + 12.0 * triangles) * (smooth ? 2 : 1);
    return bytes / mesh;
  }

  @Test
  void allThatIsAllocatedIsUnderThreeMeshes() {
    double flat = allocatedMeshes(false);
    double smooth = allocatedMeshes(true);
    assertTrue(flat < 3 && smooth < 3, flat + " and " + smooth + " meshes");
  }

  /** Lines that are made as they are read: nobody could read them again. */
  private static final class Lines extends InputStream {

    private static final int POINTS = 500_000;

    private byte[] line = {};
    private int at;
    private int number;

    @Override
    public int read() {
      if (at == line.length && number < 2 * POINTS) {
        int i = number % POINTS;
        String text = number < POINTS ? "v " + i + " 0.5 1\n" : "f " + (i + 1) + " 1 -2\n";
        line = text.getBytes(StandardCharsets.UTF_8);
        at = 0;
        number++;
      }
      return at == line.length ? -1 : line[at++];
    }

    @Override
    public int read(byte[] block, int offset, int length) {
      int count = 0;
      for (int c = 0; count < length && (c = read()) >= 0; count++) {
        block[offset + count] = (byte) c;
      }
      return count == 0 && length > 0 ? -1 : count;
    }
  }

  @Test
  void aMillionLinesAreReadInOnePassAndBoundedMemory() throws IOException {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    Lines lines = new Lines();
    while (lines.read() >= 0) {
      // counts what the lines themselves take
    }
    long before = threads.getCurrentThreadAllocatedBytes();
    lines = new Lines();
    while (lines.read() >= 0) {
      // the same once more
    }
    long own = threads.getCurrentThreadAllocatedBytes() - before;
    before = threads.getCurrentThreadAllocatedBytes();
    ObjModel model = ObjReader.read(new Lines(), "m.obj");
    long bytes = threads.getCurrentThreadAllocatedBytes() - before - own;
    // The first and the last but one of the faces name a point twice
    assertEquals(Lines.POINTS - 2, model.mesh().triangles());
    double mesh = 24.0 * Lines.POINTS + 12.0 * model.mesh().triangles();
    assertTrue(bytes < 3 * mesh, bytes / mesh + " meshes");
  }
}
