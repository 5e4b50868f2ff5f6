package glint.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import glint.io.SceneFiles;
import glint.render.RenderSettings;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

class LongRunTest {

  /** What the oblique half-plane of scenes/analytic/coverage.yaml covers of the middle pixel. */
  private static final double COVERED = 0.6555989583333334;

  private static final String HALF_PLANE =
      """
      scenes:
        half-plane:
          image: {width: 5, height: 5}
          camera: {position: [0, 0, 5], look_at: [0, 0, 0], orthographic: 5}
          lights: [{ambient: {color: 1}}]
          surfaces:
            - quad: {corner: [80.075, -59.9, 0], edge1: [-60, -80, 0], edge2: [-160, 120, 0]}
      """;

  private static Prepared scene() throws IOException {
    ByteArrayInputStream in = new ByteArrayInputStream(HALF_PLANE.getBytes(StandardCharsets.UTF_8));
    Scene scene = SceneFiles.read(in, "a.yaml", path -> in).scenes().get(0);
    return Prepared.of(scene);
  }

  private static RenderSettings settings() {
    return new RenderSettings(5, 5, 1, 0, OptionalInt.empty(), 2, 32, Set.of());
  }

  @Test
  void aLongRunFindsTheTruth() throws IOException {
    Reference reference = LongRun.of(scene(), settings(), () -> false);
    double[] rgb = reference.image().rgb();
    double middle = Transfer.SRGB.level(rgb[3 * (2 * 5 + 2)]);
    assertEquals(Transfer.SRGB.level(COVERED), middle, 0.125);
    assertEquals(1, rgb[3 * (4 * 5)], 1e-15);
    assertEquals(0, rgb[3 * 4], 0);
    assertTrue(
        reference.uncertainty() > 0 && reference.uncertainty() < 0.125,
        "off by " + reference.uncertainty());
  }

  @Test
  void aLongRunCanBeCancelled() throws IOException {
    Prepared scene = scene();
    assertThrows(CancellationException.class, () -> LongRun.of(scene, settings(), () -> true));
  }
}
