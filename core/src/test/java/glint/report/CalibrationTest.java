package glint.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.report.Honesty.Claim;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Claims against truth, where it is known how well they agree. */
class CalibrationTest {

  private static final int PIXELS = 200_000;

  /** Normal errors of many sizes, claimed too large by a factor. */
  private static Calibration normal(double factor) {
    Random random = new Random(1);
    double[] claimed = new double[PIXELS];
    double[] actual = new double[PIXELS];
    for (int i = 0; i < PIXELS; i++) {
      double sigma = Math.pow(10, random.nextDouble() * 2 - 1);
      claimed[i] = factor * sigma;
      actual[i] = Math.abs(sigma * random.nextGaussian());
    }
    return Calibration.of(claimed, actual, 1);
  }

  @Test
  void standardErrorsThatAreRightCoverAsManyAsTheyShould() {
    Calibration c = normal(1);
    assertEquals(1, c.ratio(), 0.01);
    // The share within one standard error itself deviates by 0.001.
    assertEquals(0.6827, c.coverage().get(0), 0.004);
    assertEquals(0.9545, c.coverage().get(1), 0.002);
    assertEquals(0.9973, c.coverage().get(2), 0.0005);
    assertEquals(10, c.reliability().size());
    double before = 0;
    for (Calibration.Bin bin : c.reliability()) {
      assertEquals(PIXELS / 10, bin.pixels());
      assertEquals(1, bin.actual() / bin.claimed(), 0.025);
      assertTrue(bin.claimed() > before);
      before = bin.claimed();
    }
  }

  @Test
  void carefulClaimsShowInRatioAndCoverage() {
    Calibration c = normal(2);
    assertEquals(2, c.ratio(), 0.02);
    assertEquals(0.9545, c.coverage().get(0), 0.002);
    assertEquals(0.5, c.reliability().get(3).actual() / c.reliability().get(3).claimed(), 0.01);
    assertEquals(normal(1).spearman(), c.spearman(), 1e-12);
  }

  @Test
  void everyFigureOfAFewPixels() {
    double[] claimed = {0, 1, 2, 3, 0, 0.5};
    double[] actual = {1e-9, 2, 2, 9.5, 4, 0.5};
    Calibration c = Calibration.of(claimed, actual, 0.75);
    assertEquals(6, c.pixels());
    assertEquals(1, c.flat());
    assertEquals(Math.sqrt(14.25 / (4 + 4 + 90.25 + 16 + 0.25)), c.ratio(), 1e-15);
    assertEquals(List.of(2 / 5.0, 3 / 5.0, 3 / 5.0), c.coverage());
    // Only the pixel that claims nothing and errs by 4 is below 0.75 and above it.
    assertEquals(1, c.silentMisses());
    assertEquals(5, c.reliability().size());
    assertEquals(new Calibration.Bin(1, 0, 4), c.reliability().get(0));
    assertEquals(new Calibration.Bin(1, 3, 9.5), c.reliability().get(4));
    // Ranks 3 4 5 1 2 and 2.5 2.5 5 4 1: sums of products of deviations 3.5, 10 and 9.5.
    assertEquals(3.5 / Math.sqrt(95), c.spearman(), 1e-15);
  }

  @Test
  void roundingIsCoveredByAClaimOfNothing() {
    Calibration c = Calibration.of(new double[] {1e-12, 0}, new double[] {2e-6, 0.5e-6}, 1);
    assertEquals(1, c.flat());
    assertEquals(List.of(0.0, 0.0, 0.0), c.coverage());
    c = Calibration.of(new double[] {2e-6, 0}, new double[] {0, 0}, 1);
    assertEquals(List.of(1.0, 1.0, 1.0), c.coverage());
  }

  @Test
  void equalValuesShareTheirRanks() {
    assertArrayEquals(new double[] {4.5, 2, 2, 4.5, 2}, Ranks.of(new double[] {7, 1, 1, 7, 1}));
    assertArrayEquals(new int[] {1, 2, 4, 0, 3}, Ranks.order(new double[] {7, 1, 1, 7, 1}));
    double[] up = IntStream.range(0, 50).mapToDouble(i -> i + 1).toArray();
    double[] cubes = Arrays.stream(up).map(v -> v * v * v).toArray();
    assertEquals(1, Calibration.of(up, cubes, 1).spearman(), 1e-12);
    double[] inverse = Arrays.stream(up).map(v -> 1 / v).toArray();
    assertEquals(-1, Calibration.of(up, inverse, 1).spearman(), 1e-12);
    Arrays.fill(cubes, 3);
    assertTrue(Double.isNaN(Calibration.of(up, cubes, 1).spearman()));
  }

  @Test
  void everyPixelHasOneClaim() {
    assertThrows(
        IllegalArgumentException.class, () -> Calibration.of(new double[1], new double[2], 1));
  }

  @Test
  void imagesKeepTheirTargetsOrNot() {
    Honesty honesty =
        Honesty.of(
            List.of(
                new Claim(1, 1, 0.75),
                new Claim(1, 0.5, 1),
                new Claim(0.5, 0.5, 0.51),
                new Claim(2, 0.04, 0)));
    assertEquals(4, honesty.runs());
    assertEquals(0.75, honesty.kept());
    assertEquals(0.75, honesty.ratio().min());
    assertEquals(1.02, honesty.ratio().median(), 1e-15);
    assertEquals(2, honesty.ratio().max());
    assertTrue(Double.isNaN(Honesty.of(List.of(new Claim(1, 0, 0))).ratio().median()));
  }
}
