package glint.fuzz;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Random scenes of extreme numbers: no exception, no NaN or infinity, and the tree finds what a
 * scan finds.
 */
class SceneFuzzTest {

  @Test
  void scenesOfExtremeNumbers() throws InterruptedException {
    fuzz(20_000);
  }

  @Test
  @Tag("soak")
  void tenMillionScenesOfExtremeNumbers() throws InterruptedException {
    fuzz(10_000_000);
  }

  private static void fuzz(long scenes) throws InterruptedException {
    Fuzzing fuzzing = new Fuzzing(scenes);
    fuzzing.run();
    // The scenes must show something, or nothing would be tried.
    assertTrue(fuzzing.refusedShare() < 0.5, "refused: " + fuzzing.refusedShare());
    assertTrue(fuzzing.hitShare() > 0.3, "hits: " + fuzzing.hitShare());
    assertTrue(fuzzing.shadowRaysPerScene() > 2, "shadow rays: " + fuzzing.shadowRaysPerScene());
  }
}
