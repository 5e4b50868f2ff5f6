package glint.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import glint.image.Comparison.PixelError;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class ComparisonTest {

  /** Computed with NumPy 2.4.6 in 64-bit floats. */
  @ParameterizedTest
  @CsvSource({
    "NOISE, 0.0588530324811136, 0.16831634271754625,"
        + " 0.04694005152599306, 0.04199676270333112, 26.53369600331001",
    "SHIFT, 0.06032511885888096, 0.9063733418543819,"
        + " 0.014787369742864629, 1.0776871866313873, 23.95781700250636",
    "FIREFLY, 0.03456505649101418, 1,"
        + " 0.0011947431302270011, 11.947431302270012, 29.2272545799326",
    "HUE, 0.43469807343553435, 0.5323942360439751,"
        + " 0.3549294906959834, 31.296701959408708, 6.969155485671155",
  })
  void agreesWithNumPy(
      Patterns pattern, double rmse, double max, double mae, double mrse, double psnr) {
    Comparison comparison = compare(pattern.testImage(), pattern.referenceImage());
    assertEquals(rmse, comparison.rmse(), 1e-14);
    assertEquals(max, comparison.max(), 1e-14);
    assertEquals(mae, comparison.mae(), 1e-14);
    assertEquals(mrse, comparison.mrse(), 1e-12);
    assertEquals(psnr, comparison.psnr().orElseThrow(), 1e-10);
  }

  @Test
  void equalImagesHaveNoError() {
    Image image = Patterns.NOISE.testImage();
    Comparison comparison = compare(image, image);
    assertEquals(0, comparison.rmse());
    assertEquals(0, comparison.max());
    assertEquals(0, comparison.mae());
    assertEquals(0, comparison.mrse());
    assertEquals(OptionalDouble.empty(), comparison.psnr());
    assertEquals(1, comparison.ssim(), 1e-15);
    assertEquals(0, comparison.flipMean());
    assertEquals(0, comparison.flipP99());
    assertEquals(0, comparison.levelsRmse());
    assertEquals(0, comparison.levelsMax());
    assertEquals(0, comparison.invalid());
    assertEquals(new PixelError(0, 0, 0), comparison.worst().get(0));
    assertEquals(10, comparison.worst().size());
  }

  @Test
  void constantOffsetIsTheErrorOfEveryPixel() {
    Comparison comparison =
        Comparison.of(constant(20, 15, 0.5), constant(20, 15, 0.25), Transfer.LINEAR);
    assertEquals(20, comparison.width());
    assertEquals(15, comparison.height());
    assertEquals(0.25, comparison.rmse());
    assertEquals(0.25, comparison.max());
    assertEquals(0.25, comparison.mae());
    assertEquals(0.0625 / (0.26 * 0.26), comparison.mrse(), 1e-12);
    assertEquals(20 * Math.log10(4), comparison.psnr().orElseThrow(), 1e-12);
    assertEquals(63.75, comparison.levelsRmse());
    assertEquals(63.75, comparison.levelsMax());
  }

  @Test
  void levelsAreThoseOfTheTransferCurve() {
    // Half-covered white pixel: averaged in linear light it is level 187.516, not 127.5
    Comparison comparison = compare(constant(3, 2, 0.5), constant(3, 2, 0));
    assertEquals(187.516, comparison.levelsRmse(), 5e-4);
    assertEquals(comparison.levelsMax(), comparison.levelsRmse(), 1e-12);
  }

  @Test
  void differencesBeyondTheDisplayAreLinearOnly() {
    Comparison comparison = compare(constant(12, 12, 3), constant(12, 12, 1));
    assertEquals(2, comparison.rmse());
    assertEquals(0, comparison.levelsMax());
    assertEquals(0, comparison.flipMean());
    assertEquals(OptionalDouble.empty(), comparison.psnr());
  }

  @Test
  void blackAgainstWhiteIsZeroDecibel() {
    Comparison comparison = compare(constant(1, 1, 0), constant(1, 1, 1));
    assertEquals(0, comparison.psnr().orElseThrow(), 1e-14);
    assertEquals(255, comparison.levelsMax(), 1e-12);
  }

  @Test
  void negativeReferenceCountsAsBlackInTheRelativeError() {
    Comparison comparison = compare(constant(1, 1, 0), constant(1, 1, -0.01));
    assertEquals(1, comparison.mrse(), 1e-15);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void invalidChannelCountsAsWhiteAgainstBlack(double bad) {
    Image good = constant(20, 20, 0.5);
    Image broken = constant(20, 20, 0.5);
    broken.set(7, 13, 0.5, bad, 0.5);
    for (Comparison comparison :
        List.of(compare(broken, good), compare(good, broken), compare(broken, broken))) {
      assertEquals(1, comparison.invalid());
      assertEquals(new PixelError(7, 13, 1), comparison.worst().get(0));
      assertEquals(1, comparison.max());
      assertEquals(Math.sqrt(1 / 1200.0), comparison.rmse(), 1e-15);
      assertEquals(1e4 / 1200, comparison.mrse(), 1e-11);
      assertEquals(255, comparison.levelsMax(), 1e-12);
      assertEquals(10 * Math.log10(1200), comparison.psnr().orElseThrow(), 1e-12);
      assertTrue(comparison.ssim() < 0.99);
      assertTrue(comparison.flipMean() > 0.001 && comparison.flipMean() < 1);
    }
  }

  @Test
  void worstPixelsComeLargestFirstAndEqualOnesInRowOrder() {
    Image image = constant(6, 5, 0.25);
    List<PixelError> expected = new ArrayList<>();
    image.set(4, 3, 0.25, 0.25, 1.25);
    expected.add(new PixelError(4, 3, 1));
    image.set(1, 0, 0.75, 0.25, 0.25);
    image.set(0, 4, 0.25, -0.25, 0.5);
    expected.add(new PixelError(1, 0, 0.5));
    expected.add(new PixelError(0, 4, 0.5));
    for (int x = 0; x < 6; x++) {
      image.set(x, 2, 0.375, 0.375, 0.375);
      expected.add(new PixelError(x, 2, 0.125));
    }
    expected.add(new PixelError(0, 0, 0));
    assertEquals(expected, compare(image, constant(6, 5, 0.25)).worst());
  }

  @Test
  void fewerThanTenPixelsAreAllAmongTheWorst() {
    assertEquals(6, compare(constant(3, 2, 0), constant(3, 2, 1)).worst().size());
  }

  @ParameterizedTest
  @EnumSource(Transfer.class)
  void flipIsOfTheCodesOnAnSrgbDisplay(Transfer transfer) {
    // Whatever light the codes stand for: equal codes are an equal picture. Of two constant greys
    // FLIP is the redistributed power 0.7 of the difference in L*
    Comparison other = Comparison.of(codes(transfer, 153), codes(transfer, 128), transfer);
    assertEquals(0.2810234941243814, other.flipMean(), 1e-8);
  }

  @Test
  void percentileLiesBetweenTheNearestRanks() {
    // 1 × 1 has one rank; of two pixels, each alone in its own view, rank 0.99 lies between
    Comparison one = compare(constant(1, 1, 0.5), constant(1, 1, 0.25));
    assertEquals(one.flipMean(), one.flipP99());
    Image half = constant(2, 1, 0.5);
    half.set(1, 0, 0.25, 0.25, 0.25);
    ImagePair pair = new ImagePair(half, constant(2, 1, 0.5));
    double[] map =
        Flip.map(pair.imageDisplay(Transfer.SRGB), pair.referenceDisplay(Transfer.SRGB), 2, 1);
    Arrays.sort(map);
    assertTrue(map[0] < map[1]);
    assertEquals(
        map[0] + 0.99 * (map[1] - map[0]), compare(half, constant(2, 1, 0.5)).flipP99(), 1e-15);
  }

  @Test
  void refusesImagesOfDifferentSize() {
    Image wide = new Image(3, 2);
    Image high = new Image(2, 3);
    Exception e = assertThrows(IllegalArgumentException.class, () -> compare(wide, high));
    assertEquals("the images differ in size: 3x2 and 2x3", e.getMessage());
  }

  private static Comparison compare(Image image, Image reference) {
    return Comparison.of(image, reference, Transfer.SRGB);
  }

  private static Image constant(int width, int height, double value) {
    Image image = new Image(width, height);
    Arrays.fill(image.rgb(), value);
    return image;
  }

  private static Image codes(Transfer transfer, int code) {
    return constant(24, 24, transfer.decode(code / 255.0));
  }
}
