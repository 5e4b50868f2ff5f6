package glint.scenes;

import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.scene.Footprint;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What is foretold of a scene's memory bounds what it takes, and not by far where that is much. */
class FootprintTest {

  private static final long MUCH = 1 << 20;

  @ParameterizedTest
  @MethodSource("glint.scenes.Repository#sceneFiles")
  void boundsWhatIsTaken(Path file) {
    for (Scene scene : Repository.read(file).scenes()) {
      long foretold = Footprint.of(scene);
      long taken = Prepared.of(scene).geometryBytes();
      String which = scene.name() + ": " + foretold + " " + taken;
      assertTrue(foretold >= taken, which);
      assertTrue(taken < MUCH || foretold <= 2 * taken, which);
    }
  }
}
