package glint.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FlipTest {

  /**
   * Mean and 99th percentile of the error maps of flip-evaluator 1.7, the authors' implementation
   * (LDR, default viewing distance; numpy.percentile). It works in 32-bit floats, which on nearly
   * black and on constant pictures costs it up to 7e-5 in single pixels, elsewhere 3e-6.
   */
  @ParameterizedTest
  @CsvSource({
    "NOISE,   0.10762332678277745,  0.2117828196287155,  3e-6",
    "SHIFT,   0.12226053131671506,  0.4643879663944242,  3e-6",
    "FIREFLY, 0.017095914986820473, 0.5988095068931555,  7e-5",
    "CHECKER, 0.5586283591799525,   0.9114810740947723,  3e-6",
    "HUE,     0.9672534465789795,   0.9672534465789795,  7e-5",
    "GREY,    0.2810722887516022,   0.2810722887516022,  7e-5",
    "CORNER,  0.4717668063487067,   0.8860430300235748,  3e-6",
    "TINY,    0.5486451372504234,   0.9459907770156859,  3e-6",
  })
  void agreesWithTheAuthors(Patterns pattern, double mean, double p99, double tolerance) {
    Comparison comparison = compare(pattern);
    assertEquals(mean, comparison.flipMean(), tolerance);
    assertEquals(p99, comparison.flipP99(), tolerance);
  }

  /**
   * The same from the paper's formulas with whole two-dimensional kernels in 64-bit floats (NumPy
   * 2.4.6, scipy.ndimage.correlate with mode "nearest"). Constant pictures leave the root of a
   * rounding error, 1e-8, as their edges.
   */
  @ParameterizedTest
  @CsvSource({
    "NOISE,   0.10762335083922525,  0.21178260859926976, 1e-12",
    "SHIFT,   0.1222605288198369,   0.4643879642584399,  1e-12",
    "FIREFLY, 0.017098656943388156, 0.5988096287559124,  1e-12",
    "CHECKER, 0.5586282387060292,   0.9114810542248092,  1e-12",
    "HUE,     0.9672490377606545,   0.9672490377606545,  1e-8",
    "GREY,    0.281023497441287,    0.28102349744128696, 1e-8",
    "CORNER,  0.47176682924006624,  0.8860431734694887,  1e-12",
    "TINY,    0.5486451768136843,   0.9459908075989102,  1e-12",
  })
  void agreesWithThePaper(Patterns pattern, double mean, double p99, double tolerance) {
    Comparison comparison = compare(pattern);
    assertEquals(mean, comparison.flipMean(), tolerance);
    assertEquals(p99, comparison.flipP99(), tolerance);
  }

  @Test
  void equalImagesHaveNoError() {
    double[][] planes = Patterns.NOISE.pair().imageDisplay(Transfer.SRGB);
    double[] map = Flip.map(planes, planes, Patterns.NOISE.width, Patterns.NOISE.height);
    assertTrue(Arrays.stream(map).allMatch(error -> error == 0));
  }

  @Test
  void greenForBlueIsTheWorst() {
    double[] map = Flip.map(new double[][] {{0}, {1}, {0}}, new double[][] {{0}, {0}, {1}}, 1, 1);
    assertEquals(1, map[0], 1e-6); // XYZ to RGB and back holds to 7 digits only
  }

  @Test
  void errorIsTheSameEitherWayRound() {
    ImagePair pair = Patterns.CORNER.pair();
    double[][] a = pair.imageDisplay(Transfer.SRGB);
    double[][] b = pair.referenceDisplay(Transfer.SRGB);
    int width = pair.width();
    int height = pair.height();
    assertTrue(Arrays.equals(Flip.map(a, b, width, height), Flip.map(b, a, width, height)));
  }

  private static Comparison compare(Patterns pattern) {
    return Comparison.of(pattern.testImage(), pattern.referenceImage(), Transfer.SRGB);
  }
}
