package glint.image;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.color.Transfer;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SsimTest {

  /**
   * scikit-image 0.26.0: structural_similarity(…, gaussian_weights=True, sigma=1.5,
   * use_sample_covariance=False, data_range=1, channel_axis=-1) of 64-bit floats.
   */
  @ParameterizedTest
  @CsvSource({
    "NOISE,    0.5205350505036176",
    "SHIFT,    0.8474642649833886",
    "FIREFLY,  0.8755539000639992",
    "CHECKER,  0.003614808229608251",
    "HUE,      0.7003505000965689",
    "GREY,     0.9842962861156367",
    "CORNER,  -0.02284351101852476",
  })
  void agreesWithScikitImage(Patterns pattern, double expected) {
    Comparison comparison =
        Comparison.of(pattern.testImage(), pattern.referenceImage(), Transfer.SRGB);
    assertEquals(expected, comparison.ssim(), 1e-10);
  }

  @Test
  void equalImagesAreOne() {
    double[][] planes = Patterns.NOISE.pair().imageDisplay(Transfer.SRGB);
    assertEquals(1, Ssim.of(planes, planes, Patterns.NOISE.width, Patterns.NOISE.height), 1e-15);
  }

  @Test
  void constantGreysDifferInLuminanceOnly() {
    // (2ab + C1) / (a² + b² + C1), whatever the size
    double expected = (2 * 0.5 * 0.25 + 1e-4) / (0.25 + 0.0625 + 1e-4);
    assertEquals(expected, ssimOfConstants(20, 13, 0.5, 0.25), 1e-12);
    assertEquals(expected, ssimOfConstants(20, 3, 0.5, 0.25), 1e-12);
    assertEquals(expected, ssimOfConstants(2, 10, 0.5, 0.25), 1e-12);
    assertEquals(expected, ssimOfConstants(1, 1, 0.5, 0.25), 1e-12);
  }

  @Test
  void windowShrinksToASmallImage() {
    // 3 × 1 pixels leave one window with the weights g, 1, g (scaled to the sum 1)
    double g = Math.exp(-1 / 4.5);
    double w = g / (1 + 2 * g);
    double[] a = {0.1, 0.4, 0.2};
    double[] b = {0.3, 0.4, 0.9};
    double meanA = w * 0.1 + (1 - 2 * w) * 0.4 + w * 0.2;
    double meanB = w * 0.3 + (1 - 2 * w) * 0.4 + w * 0.9;
    double varianceA = 0;
    double varianceB = 0;
    double covariance = 0;
    for (int i = 0; i < 3; i++) {
      double weight = i == 1 ? 1 - 2 * w : w;
      varianceA += weight * (a[i] - meanA) * (a[i] - meanA);
      varianceB += weight * (b[i] - meanB) * (b[i] - meanB);
      covariance += weight * (a[i] - meanA) * (b[i] - meanB);
    }
    double luminance = (2 * meanA * meanB + 1e-4) / (meanA * meanA + meanB * meanB + 1e-4);
    double structure = (2 * covariance + 9e-4) / (varianceA + varianceB + 9e-4);
    double[][] planesA = {a, a, a};
    double[][] planesB = {b, b, b};
    assertEquals(luminance * structure, Ssim.of(planesA, planesB, 3, 1), 1e-13);
    assertEquals(luminance * structure, Ssim.of(planesA, planesB, 1, 3), 1e-13);
  }

  private static double ssimOfConstants(int width, int height, double a, double b) {
    return Ssim.of(constant(width * height, a), constant(width * height, b), width, height);
  }

  private static double[][] constant(int pixels, double value) {
    double[][] planes = new double[3][pixels];
    for (double[] plane : planes) {
      Arrays.fill(plane, value);
    }
    return planes;
  }
}
