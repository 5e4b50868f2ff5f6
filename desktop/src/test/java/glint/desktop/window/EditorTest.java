package glint.desktop.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Checks how places are told to editors. */
class EditorTest {

  private static final Path FILE = Path.of("a b.yaml").toAbsolutePath();
  private static final Place PLACE = new Place(FILE, 12, 7);

  @Test
  void aKnownEditorIsToldTheLine() {
    assertEquals(
        Optional.of(List.of("/usr/bin/code", "-n", "--goto", FILE + ":12:7")),
        command(Map.of("VISUAL", "/usr/bin/code -n --wait", "EDITOR", "vi")));
    assertEquals(
        Optional.of(List.of("Kate.exe", "--line", "12", "--column", "7", FILE.toString())),
        command(Map.of("EDITOR", "Kate.exe")));
  }

  @Test
  void anEditorForTerminalsIsLeftAlone() {
    assertEquals(Optional.empty(), command(Map.of("VISUAL", "vim", "EDITOR", "nano")));
    assertEquals(Optional.empty(), command(Map.of("VISUAL", " ")));
    assertEquals(Optional.empty(), command(Map.of()));
  }

  @Test
  void aProblemBeginsWithItsPlace() {
    assertEquals(
        Optional.of(new Place(Path.of("C:/a.yaml"), 3, 14)),
        Place.of("C:/a.yaml:3:14: 'x:1:2: ' is not a number"));
    assertEquals(Optional.empty(), Place.of("a.yaml: no such file or folder"));
  }

  private static Optional<List<String>> command(Map<String, String> environment) {
    return new Editor(environment).command(PLACE);
  }
}
