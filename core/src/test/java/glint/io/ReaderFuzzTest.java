package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import glint.geometry.Mesh;
import glint.geometry.MeshFacts;
import glint.scene.Prepared;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Damaged files never make a reader throw, hang or hoard memory, and always say in one line what is
 * wrong.
 */
class ReaderFuzzTest {

  private static final int ROUNDS = 2000;
  private static final int LONG_ROUNDS = 200_000;

  /** What reading a file of a few kilobytes may allocate, in bytes. */
  private static final long MOST_ALLOCATED = 32 << 20;

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  @ParameterizedTest
  @EnumSource
  @Timeout(value = 5, unit = TimeUnit.MINUTES) // a hang, not a speed
  void damagedFiles(Damage kind) {
    fuzz(kind, ROUNDS);
  }

  @ParameterizedTest
  @EnumSource
  @Tag("soak")
  @Timeout(value = 60, unit = TimeUnit.MINUTES)
  void manyDamagedFiles(Damage kind) {
    fuzz(kind, LONG_ROUNDS);
  }

  private static void fuzz(Damage kind, int rounds) {
    assertTrue(check(kind, kind.good(), new Random(0)), kind + " is not good itself");
    long bad = IntStream.range(0, rounds).parallel().filter(round -> !isGood(kind, round)).count();
    // Much damage must be seen, or this test would damage too little.
    assertTrue(bad > rounds / 4, "only " + bad + " bad files");
  }

  private static boolean isGood(Damage kind, int round) {
    Random random = new Random(20131 + 1_000_003L * round + kind.ordinal());
    byte[] bytes = kind.draw(random);
    long before = THREADS.getCurrentThreadAllocatedBytes();
    try {
      boolean good = check(kind, bytes, random);
      long allocated = THREADS.getCurrentThreadAllocatedBytes() - before;
      assertTrue(allocated < MOST_ALLOCATED, allocated + " bytes of memory");
      return good;
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      String text = new String(bytes, StandardCharsets.UTF_8);
      throw new AssertionError(kind + ", round " + round + ":\n" + text, e);
    }
  }

  /** Returns whether the file was good. */
  private static boolean check(Damage kind, byte[] bytes, Random random) {
    return switch (kind) {
      case SCENES, PAGE -> checkScenes(bytes, "f.yaml");
      case COURSE -> checkScenes(bytes, "f.txt");
      case MODEL -> checkModel(bytes);
      case LIBRARY -> checkLibrary(bytes);
      case SCENE_OF_MODEL -> checkTogether(bytes, random);
    };
  }

  private static boolean checkScenes(byte[] bytes, String fileName) {
    SceneFile file = Resources.read(bytes, fileName);
    assertTrue(!(file.problems().isEmpty() && file.scenes().isEmpty()));
    checkLines(file.problems(), file.notes(), Problems.MOST, bytes.length);
    return file.problems().isEmpty();
  }

  private static boolean checkModel(byte[] bytes) {
    ObjModel model = ObjText.read(bytes);
    checkLines(model.problems(), model.notes(), 10, bytes.length);
    assertEquals(model.problems().isEmpty(), model.mesh() != null);
    if (model.mesh() != null) {
      checkMesh(model.mesh(), bytes.length);
      assertEquals(model.mesh().parts(), model.materials().size());
    }
    SceneFile alone = Resources.read(bytes, "m.obj");
    checkLines(alone.problems(), alone.notes(), 20, bytes.length);
    assertTrue(alone.problems().isEmpty() != alone.scenes().isEmpty());
    alone.scenes().forEach(Prepared::of);
    return model.problems().isEmpty();
  }

  private static void checkMesh(Mesh mesh, int bytes) {
    assertTrue(mesh.triangles() <= bytes);
    assertTrue(MeshFacts.area(mesh) >= 0);
  }

  private static boolean checkLibrary(byte[] bytes) {
    try {
      MtlLibrary library = MtlReader.read(new ByteArrayInputStream(bytes), "m.mtl");
      checkLines(library.problems(), library.notes(), 10, bytes.length);
      assertTrue(library.problems().isEmpty() || library.materials().isEmpty());
      return library.problems().isEmpty();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** A scene, its model and that one's library, of which one is damaged. */
  private static boolean checkTogether(byte[] bytes, Random random) {
    int which = random.nextInt(3);
    byte[] scene = which == 0 ? bytes : Damage.SCENE_OF_MODEL.good();
    byte[] model = which == 1 ? Damage.MODEL.draw(random) : Damage.MODEL.good();
    byte[] library = which == 2 ? Damage.LIBRARY.draw(random) : Damage.LIBRARY.good();
    SceneFolder folder =
        path -> {
          if (!path.equals("a.obj") && !path.equals("a.mtl")) {
            throw new IOException("no such file");
          }
          return new ByteArrayInputStream(path.equals("a.obj") ? model : library);
        };
    SceneFile file = Resources.read(scene, "f.yaml", folder);
    assertTrue(!(file.problems().isEmpty() && file.scenes().isEmpty()));
    int longest = Math.max(scene.length, Math.max(model.length, library.length));
    checkLines(file.problems(), file.notes(), Problems.MOST + 20, longest);
    file.scenes().forEach(Prepared::of);
    return file.problems().isEmpty();
  }

  private static void checkLines(List<Problem> problems, List<Problem> notes, int most, int bytes) {
    assertTrue(problems.size() <= most + 1 && notes.size() <= most + 1);
    List<Problem> all = new ArrayList<>(problems);
    all.addAll(notes);
    for (Problem problem : all) {
      String line = problem.toString();
      assertTrue(line.length() < 600 && line.indexOf('\n') < 0 && line.indexOf('\r') < 0, line);
      assertTrue(problem.line() >= 0 && problem.line() <= 1 + bytes, line);
      assertTrue(problem.line() == 0 || problem.column() >= 1, line);
      assertTrue(problem.column() <= 1 + bytes, line);
    }
  }
}
