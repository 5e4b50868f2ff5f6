package glint.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.io.SceneFile;
import glint.scene.Expectation;
import glint.scene.Scene;
import glint.verify.Verdict;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The scenes that carry their own answers. */
class AnalyticScenesTest {

  private static final Map<String, List<Rgb>> FORMS = ClosedForms.all();

  /** What the formulas lose in doubles. */
  private static final double ROUNDING = 1e-14;

  private static List<Path> files() {
    try (Stream<Path> files = Files.list(Repository.root().resolve("scenes/analytic"))) {
      return files.sorted().collect(Collectors.toList());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static Stream<Arguments> scenes() {
    return files().stream()
        .flatMap(file -> Repository.read(file).scenes().stream())
        .map(scene -> Arguments.of(scene.name(), scene));
  }

  @Test
  void everyFileIsSound() {
    Set<String> names = new TreeSet<>();
    for (Path path : files()) {
      SceneFile file = Repository.read(path);
      assertEquals(List.of(), file.problems());
      assertEquals(List.of(), file.notes());
      for (Scene scene : file.scenes()) {
        assertTrue(names.add(scene.name()), scene.name());
        assertNotEquals(scene.name(), scene.title());
      }
    }
    assertEquals(new TreeSet<>(FORMS.keySet()), names, "scenes and formulas");
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("scenes")
  void theFileSaysWhatItsFormulaSays(String name, Scene scene) {
    List<Rgb> values =
        scene.expectations().stream().map(Expectation::value).collect(Collectors.toList());
    assertEquals(FORMS.get(name).size(), values.size());
    for (int i = 0; i < values.size(); i++) {
      Rgb expected = FORMS.get(name).get(i);
      assertClose(expected.r(), values.get(i).r());
      assertClose(expected.g(), values.get(i).g());
      assertClose(expected.b(), values.get(i).b());
    }
  }

  private static void assertClose(double expected, double actual) {
    assertEquals(expected, actual, ROUNDING * expected);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("scenes")
  void thePictureShowsWhatTheFileSays(String name, Scene scene) {
    List<String> wrong = new ArrayList<>();
    for (Verdict verdict : Verdict.of(scene, Runtime.getRuntime().availableProcessors())) {
      if (!verdict.passed()) {
        wrong.add(verdict.toString());
      }
    }
    assertEquals(List.of(), wrong);
  }

  /** A pixel is demanded to 1e-12 of its value, or exactly, unless its samples see an edge. */
  @ParameterizedTest(name = "{0}")
  @MethodSource("scenes")
  void whatOneRaySeesIsDemandedToTheLastDigits(String name, Scene scene) {
    for (Expectation each : scene.expectations()) {
      boolean fine = each.tolerance() == 0 && each.relative() <= 1e-12;
      assertTrue(fine || each.samples() >= 1024, each::toString);
    }
  }

  @ParameterizedTest
  @CsvSource({"pixel-half, 188", "pixel-quarter, 137", "pixel-grey, 118"})
  void theCodesOfHalfLitPixels(String name, int code) {
    Scene scene = (Scene) scenes().filter(s -> s.get()[0].equals(name)).findFirst().get().get()[1];
    assertEquals(code, Transfer.SRGB.code(Verdict.of(scene, 1).get(0).actual().r()));
  }
}
