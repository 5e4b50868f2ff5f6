package glint.android.apk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The core in the app is the core: its dex, translated back, renders the same images. */
@Tag("soak")
class DexTest {

  private static final String GALLERY = "../../scenes/gallery.yaml";

  /** The images of the Robolectric tests. */
  private static final String[] RUN = {GALLERY, "160", "120", "4", "2", "1"};

  private static List<String> hashes(List<String> lines) {
    return lines.stream()
        .map(line -> line.substring(0, line.lastIndexOf(' ')))
        .collect(Collectors.toList());
  }

  @ParameterizedTest
  @ValueSource(strings = {"debug", "release"})
  void rendersTheSameImages(String type, @TempDir Path folder) throws IOException {
    String harness = System.getProperty("glint.harness");
    Path translated = folder.resolve("app.jar");
    DexJar.translate(Path.of(System.getProperty("glint.apk." + type)), translated);
    JavaMachine java = JavaMachine.own();
    List<String> app = java.gallery(List.of(harness, translated.toString()), false, RUN);
    List<String> desktop =
        java.gallery(List.of(harness, System.getProperty("glint.core")), true, RUN);
    assertFalse(desktop.isEmpty());
    assertEquals(hashes(desktop), hashes(app));
  }
}
