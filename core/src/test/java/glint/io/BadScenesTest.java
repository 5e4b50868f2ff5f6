package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every way to write a scene wrongly that we know gets one clear line with its place. */
class BadScenesTest {

  static List<Resources.Bad> yaml() {
    return Resources.bad("bad-yaml.txt");
  }

  static List<Resources.Bad> cs315() {
    return Resources.bad("bad-cs315.txt");
  }

  @ParameterizedTest
  @MethodSource
  void yaml(Resources.Bad bad) {
    check(bad, "f.yaml");
  }

  @ParameterizedTest
  @MethodSource
  void cs315(Resources.Bad bad) {
    check(bad, "f.txt");
  }

  private static void check(Resources.Bad bad, String fileName) {
    SceneFile file = Resources.read(bad.text(), fileName);
    assertEquals(
        String.join("\n", bad.answers()), String.join("\n", Resources.answers(file, fileName)));
    assertFalse(file.problems().isEmpty());
    String[] lines = bad.text().split("\n", -1);
    for (Problem problem : file.problems()) {
      assertTrue(problem.line() <= lines.length, problem.toString());
      if (problem.line() > 0) {
        int length = lines[problem.line() - 1].length();
        assertTrue(problem.column() >= 1 && problem.column() <= length + 1, problem.toString());
      }
    }
  }
}
