package glint.models;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.Vector3d;
import glint.models.shape.Lathe;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The files of scenes/models. */
class ModelsTest {

  /** Gradle runs tests in the module's folder. */
  private static final Path FOLDER = Path.of("../scenes/models");

  /** They go into the app, too. */
  private static final int MOST_BYTES = 400_000;

  private static final int MOST_BYTES_TOGETHER = 1_500_000;

  @Test
  void committedFilesAreThoseThatAreMade() throws IOException {
    Map<String, String> made = Main.files();
    Set<String> there = new TreeSet<>();
    try (Stream<Path> files = Files.list(FOLDER)) {
      files.forEach(file -> there.add(file.getFileName().toString()));
    }
    assertEquals(made.keySet(), there);
    int together = 0;
    for (Map.Entry<String, String> file : made.entrySet()) {
      String text = Files.readString(FOLDER.resolve(file.getKey()));
      assertTrue(text.equals(file.getValue()), file.getKey() + ": run ./gradlew -q :models:write");
      assertTrue(text.length() <= MOST_BYTES, file.getKey());
      together += text.length();
    }
    assertTrue(together <= MOST_BYTES_TOGETHER, "all files together");
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "-0.00004, 0",
    "1, 1",
    "-2.5, -2.5",
    "0.25, .25",
    "-0.0625, -.0625",
    "10, 10",
    "123.45678, 123.4568",
    "0.99996, 1"
  })
  void numbersAreShort(double number, String text) {
    assertEquals(text, Numbers.text(number));
  }

  @Test
  void modelIsWrittenPaintByPaint() {
    Paint red = Paint.dull("red", 1, 0, 0);
    Paint lamp = Paint.dull("lamp", 0, 0, 0).glowing(1, 1, 0.5).covering(0.25);
    Model model =
        new Model()
            .add(red, Lathe.tube(3, 1, 0, 1, 1))
            .add(lamp, Lathe.tube(3, 2, 0, 2, 1))
            .add(red, Lathe.tube(3, 3, 0, 3, 1));
    String[] lines = model.obj("m").split("\n");
    assertEquals("mtllib m.mtl", lines[1]);
    assertEquals("usemtl red", lines[2]);
    assertEquals("v 0 0 1", lines[3]);
    assertEquals("usemtl lamp", lines[2 + 1 + 12 + 6]);
    assertEquals("f 13 14 17 16", lines[2 + 1 + 12 + 6 + 1 + 6]);
    assertEquals("newmtl red\nKd 1 0 0\nnewmtl lamp\nKd 0 0 0\nKe 1 1 .5\nd .25\n", model.mtl());
  }

  @Test
  void modelWithoutPaintsHasNoLibrary() {
    Model model = Model.of(Lathe.tube(3, 1, 0, 1, 1).mapped(p -> p.plus(new Vector3d(1, 0, 0))));
    assertTrue(model.obj("m").startsWith("# Made by ./gradlew -q :models:write\nv 1 0 1\n"));
    assertEquals("", model.mtl());
  }
}
