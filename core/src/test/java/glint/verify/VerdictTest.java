package glint.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Quad;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Expectation;
import glint.scene.Expectation.Pixel;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Scene;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

/** Expectations are judged as the scene format says. */
class VerdictTest {

  private static final Vector3d UP = new Vector3d(0, 1, 0);

  /** Four by two pixels of edge 1 seen along -z. */
  private static Scene.Builder scene() {
    Vector3d eye = new Vector3d(0, 0, 5);
    return new Scene.Builder("test")
        .size(4, 2)
        .camera(Camera.of(eye, Vector3d.ZERO, UP, new Orthographic(2)));
  }

  private static Material glowing(Rgb emission) {
    return new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, emission);
  }

  private static Expectation pixel(int x, int y, Rgb value, double tolerance, double relative) {
    return new Expectation(
        Optional.of(new Pixel(x, y)), value, tolerance, relative, 1, OptionalInt.empty());
  }

  private static Expectation mean(Rgb value, double tolerance, int samples) {
    return new Expectation(Optional.empty(), value, tolerance, 0, samples, OptionalInt.empty());
  }

  private static Verdict only(Scene.Builder scene, Expectation expectation) {
    return Verdict.of(scene.expect(expectation).build(), 1).get(0);
  }

  /** Only the pixel in column 2 and row 0 is lit. */
  private static Scene.Builder spot() {
    Quad quad = new Quad(Vector3d.ZERO, new Vector3d(1, 0, 0), UP);
    return scene().place(Placement.of(quad, glowing(new Rgb(1, 2, 4))));
  }

  @Test
  void aPixelIsCountedFromTheTopLeft() {
    Rgb lit = new Rgb(1, 2, 4);
    for (int x = 0; x < 4; x++) {
      for (int y = 0; y < 2; y++) {
        Rgb value = x == 2 && y == 0 ? lit : Rgb.BLACK;
        assertTrue(only(spot(), pixel(x, y, value, 0, 0)).passed());
        assertEquals(value, only(spot(), pixel(x, y, lit, 0, 0)).actual());
      }
    }
  }

  @Test
  void theMeanIsThatOfAllPixelsAndSamples() {
    Verdict verdict = only(spot(), mean(new Rgb(0.125, 0.25, 0.5), 0, 16));
    assertTrue(verdict.passed());
    // Half of the next column, too: of 16 samples in a pixel 8 lie in its left half.
    Quad quad = new Quad(new Vector3d(1, 0, 0), new Vector3d(0.5, 0, 0), UP);
    Scene.Builder more = spot().place(Placement.of(quad, glowing(Rgb.WHITE)));
    assertTrue(only(more, mean(new Rgb(0.1875, 0.3125, 0.5625), 0, 16)).passed());
  }

  @Test
  void theLargerOfBothTolerancesHolds() {
    Rgb value = new Rgb(1, 2, 5);
    assertFalse(only(spot(), pixel(2, 0, value, 0.999, 0)).passed());
    assertTrue(only(spot(), pixel(2, 0, value, 1, 0)).passed());
    assertFalse(only(spot(), pixel(2, 0, value, 0.1, 0.199)).passed());
    assertTrue(only(spot(), pixel(2, 0, value, 0.1, 0.2)).passed());
  }

  @Test
  void theWorstChannelIsReported() {
    // Off by 0.5 of 0.75, by 1 of 1.5 and by 1 of 0.5.
    Verdict verdict = only(spot(), pixel(2, 0, new Rgb(1.5, 3, 5), 0, 0.5));
    Outcome outcome = verdict.outcome("id", "what");
    assertEquals(new Outcome("id", "what", 1, 0, 0.5, 0.75, "radiance"), outcome);
    verdict = only(spot(), pixel(2, 0, new Rgb(1.5, 2, 3), 0.5, 0));
    outcome = verdict.outcome("id", "what");
    assertEquals(new Outcome("id", "what", 1, 1, 1, 0.5, "radiance"), outcome);
    // Nothing at all is allowed where nothing is expected.
    outcome = only(spot(), pixel(2, 0, new Rgb(1, 0, 4), 0, 1e-3)).outcome("id", "what");
    assertEquals(new Outcome("id", "what", 1, 1, 2, 0, "radiance"), outcome);
  }

  @Test
  void samplesThatAreNoNumbersAreWrong() {
    Quad quad = new Quad(new Vector3d(-2, -1, 0), new Vector3d(2, 0, 0), new Vector3d(0, 2, 0));
    Placement dazzling = Placement.of(quad, glowing(Rgb.grey(Double.MAX_VALUE)));
    Verdict verdict = only(scene().place(dazzling), pixel(3, 0, Rgb.BLACK, 1, 0));
    assertEquals(4, verdict.invalid());
    assertFalse(verdict.passed());
  }

  @Test
  void raysAreFollowedAsFarAsTheToleranceAsks() {
    // Plane-parallel glass before a background of 1: all that it reflects and lets through is 1.
    Material glass =
        new Material(
            Rgb.BLACK,
            Rgb.BLACK,
            Rgb.BLACK,
            1,
            Rgb.BLACK,
            Rgb.BLACK,
            Rgb.WHITE,
            new Medium(1.5, Rgb.BLACK, 0));
    Vector3d corner = new Vector3d(9, 9, 1);
    Scene.Builder slab =
        scene()
            .background(Background.constant(Rgb.WHITE))
            .place(Placement.of(new Box(corner.times(-1), corner), glass));
    assertTrue(only(slab, pixel(0, 0, Rgb.WHITE, 0, 1e-12)).passed());
    Verdict rough = Verdict.of(slab.expect(pixel(0, 0, Rgb.WHITE, 0.01, 0)).build(), 1).get(1);
    double missing = 1 - rough.actual().r();
    assertTrue(missing > 1e-6 && missing < 0.01 / 256, () -> "missing " + missing);
  }
}
