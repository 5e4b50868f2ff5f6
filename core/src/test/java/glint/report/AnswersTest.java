package glint.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.image.Image;
import glint.math.Vector3d;
import glint.render.RenderSettings;
import glint.scene.Camera;
import glint.scene.Expectation;
import glint.scene.Orthographic;
import glint.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Which of the things that a scene says of its picture are taken as truth, and what they say. */
class AnswersTest {

  private static final OptionalInt NO_DEPTH = OptionalInt.empty();
  private static final Expectation MEAN =
      new Expectation(Optional.empty(), new Rgb(0.5, 0.25, 0), 1, 0, 16, NO_DEPTH);

  private static Expectation pixel(int x, int y, Rgb value, int samples, OptionalInt depth) {
    Optional<Expectation.Pixel> pixel = Optional.of(new Expectation.Pixel(x, y));
    return new Expectation(pixel, value, 1, 0, samples, depth);
  }

  private static Scene scene(Expectation... expectations) {
    Camera camera =
        new Camera(
            new Vector3d(0, 0, 5),
            new Vector3d(0, 0, 0),
            new Vector3d(0, 1, 0),
            new Orthographic(4),
            0,
            Double.POSITIVE_INFINITY);
    Scene.Builder scene =
        new Scene.Builder("s").size(3, 2).transfer(Transfer.LINEAR).camera(camera);
    List.of(expectations).forEach(scene::expect);
    return scene.build();
  }

  @Test
  void pixelsComeBeforeTheMeanAndCentresDoNotCount() {
    Expectation centre = pixel(0, 0, Rgb.WHITE, 1, NO_DEPTH);
    Expectation one = pixel(1, 0, Rgb.WHITE, 4, NO_DEPTH);
    Expectation two = pixel(2, 1, Rgb.BLACK, 16, NO_DEPTH);
    Answers pixels = Answers.of(scene(MEAN, centre, one, two)).orElseThrow();
    assertEquals(List.of(one, two), pixels.expectations());
    assertEquals("2 exact pixels", pixels.origin());
    assertEquals(0, pixels.uncertainty());
    Answers mean = Answers.of(scene(centre, MEAN)).orElseThrow();
    assertEquals(List.of(MEAN), mean.expectations());
    assertEquals("exact mean", mean.origin());
    assertEquals("exact pixel", Answers.of(scene(one)).orElseThrow().origin());
    assertTrue(Answers.of(scene(centre)).isEmpty());
    assertTrue(Answers.of(scene()).isEmpty());
  }

  @Test
  void onlyAnswersOfOneDepthAgree() {
    Expectation shallow = pixel(0, 0, Rgb.WHITE, 4, OptionalInt.of(2));
    Expectation deep = pixel(0, 0, Rgb.BLACK, 4, OptionalInt.of(3));
    Scene scene = scene(shallow, deep, shallow);
    Answers answers = Answers.of(scene).orElseThrow();
    assertEquals(List.of(shallow, shallow), answers.expectations());
  }

  @Test
  void aSceneThatSaysSomethingKeepsItsSizeAndTheDepthOfItsAnswers() {
    OptionalInt nine = OptionalInt.of(9);
    RenderSettings asked = new RenderSettings(80, 60, 4, 7, nine, 2, 16, Set.of());
    assertEquals(asked, Answers.settings(scene(), asked));
    Scene centre = scene(pixel(0, 0, Rgb.WHITE, 1, OptionalInt.of(2)));
    RenderSettings own = new RenderSettings(3, 2, 4, 7, nine, 2, 16, Set.of());
    assertEquals(own, Answers.settings(centre, asked));
    Scene shallow = scene(pixel(0, 0, Rgb.WHITE, 4, OptionalInt.of(2)));
    RenderSettings two = new RenderSettings(3, 2, 4, 7, OptionalInt.of(2), 2, 16, Set.of());
    assertEquals(two, Answers.settings(shallow, asked));
  }

  @Test
  void onlyTheExpectedPixelsCount() {
    Image image = new Image(3, 2);
    image.set(2, 1, 0.5, 0.5, 0.5);
    Expectation right = pixel(2, 1, Rgb.grey(0.5), 4, NO_DEPTH);
    Expectation wrong = pixel(1, 0, new Rgb(0, 0, 0.25), 4, NO_DEPTH);
    Errors errors = Answers.of(scene(right, wrong)).orElseThrow().errors(image);
    assertEquals(0.25 / Math.sqrt(6), errors.linear(), 1e-15);
    assertEquals(0.25, errors.maxLinear());
    assertEquals(255 * 0.25, errors.maxLevels(), 1e-12);
  }

  @Test
  void aMeanIsOfAllPixelsInLinearLight() {
    Image image = new Image(2, 2);
    image.set(0, 0, 1, 0, 0);
    image.set(1, 1, 1, 2, 0);
    Errors errors = new Answers(List.of(MEAN), Transfer.SRGB).errors(image);
    assertEquals(0.25, errors.maxLinear());
    double level = 255 * (Transfer.SRGB.encode(0.5) - Transfer.SRGB.encode(0.25));
    assertEquals(level, errors.maxLevels(), 1e-12);
    assertEquals(level / Math.sqrt(3), errors.levels(), 1e-12);
  }
}
