package glint.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import glint.image.Image;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Figures against numbers that are known. */
class FiguresTest {

  @Test
  void theErrorsOfAnImageAreThoseOfAllItsChannels() {
    Image truth = new Image(2, 1);
    Image image = new Image(2, 1);
    image.set(0, 0, 0.3, 0, 0);
    image.set(1, 0, 0, 0.4, 7);
    truth.set(1, 0, 0, 0, 1);
    Errors errors = Errors.between(image, truth, Transfer.LINEAR);
    // Above white the display shows no difference, but there is one in linear light.
    assertEquals(255 * Math.sqrt(0.25 / 6), errors.levels(), 1e-12);
    assertEquals(255 * 0.4, errors.maxLevels(), 1e-12);
    assertEquals(Math.sqrt((0.25 + 36) / 6), errors.linear(), 1e-15);
    assertEquals(6, errors.maxLinear());
    assertThrows(
        IllegalArgumentException.class,
        () -> Errors.between(image, new Image(1, 2), Transfer.SRGB));
  }

  @Test
  void everyPixelHasItsOwnError() {
    Image truth = new Image(1, 2);
    Image image = new Image(1, 2);
    image.set(0, 1, 0.3, 0, 0.4);
    double[] errors = Errors.ofPixels(image, truth, Transfer.LINEAR);
    assertEquals(2, errors.length);
    assertEquals(0, errors[0]);
    assertEquals(255 * 0.5 / Math.sqrt(3), errors[1], 1e-12);
    assertThrows(
        IllegalArgumentException.class,
        () -> Errors.ofPixels(image, new Image(2, 1), Transfer.SRGB));
  }

  @Test
  void runsAddUpInQuadrature() {
    Errors together = Errors.together(List.of(new Errors(3, 9, 0, 1), new Errors(4, 8, 2, 5)));
    assertEquals(new Errors(Math.sqrt(12.5), 9, Math.sqrt(2), 5), together);
  }

  @Test
  void theHalvesOfAReferenceTellItsError() {
    Image one = new Image(1, 1);
    Image two = new Image(1, 1);
    one.set(0, 0, 0.5, 0.25, 0);
    two.set(0, 0, 0.25, 0.25, 0);
    Reference reference = Reference.of(one, two, "both", Transfer.LINEAR);
    assertEquals("both", reference.origin());
    assertEquals(0.375, reference.image().rgb()[0]);
    assertEquals(255 * 0.25 / Math.sqrt(3) / 2, reference.uncertainty(), 1e-12);
    assertEquals(0.125, reference.errors(one).maxLinear());
  }

  @Test
  void theMedianIsTheMiddle() {
    assertEquals(new Spread(1, 3, 9), Spread.of(9, 1, 3));
    assertEquals(new Spread(1, 2.5, 9), Spread.of(9, 3, 1, 2));
    assertEquals(new Spread(4, 4, 4), Spread.of(4));
  }

  @Property(tries = 200)
  void aPowerLawIsFoundAgain(
      @ForAll @DoubleRange(min = -3, max = 3) double slope,
      @ForAll @DoubleRange(min = -6, max = 6) double digits) {
    double factor = Math.pow(10, digits);
    double[] x = {1, 2, 5, 100, 1e4};
    double[] y = new double[x.length];
    for (int i = 0; i < x.length; i++) {
      y[i] = factor * Math.pow(x[i], slope);
    }
    PowerLaw law = PowerLaw.fit(x, y);
    assertEquals(slope, law.slope(), 1e-12);
    assertEquals(factor, law.factor(), 1e-11 * factor);
    assertEquals(y[3], law.at(100), 1e-11 * y[3]);
    if (Math.abs(slope) > 0.1) {
      assertEquals(100, law.inverse(y[3]), 1e-8);
    }
  }

  @Test
  void theLineIsThatOfLeastSquares() {
    // In logarithms to the base 2: (0, 0), (1, 0), (2, 3) have the line -0.5 + 1.5 x.
    PowerLaw law = PowerLaw.fit(new double[] {1, 2, 4}, new double[] {1, 1, 8});
    assertEquals(1.5, law.slope(), 1e-14);
    assertEquals(Math.sqrt(0.5), law.factor(), 1e-14);
    assertTrue(Double.isNaN(PowerLaw.fit(new double[] {2, 2}, new double[] {1, 3}).slope()));
  }

  @Test
  void theBootstrapFindsTheErrorOfAMean() {
    Random random = new Random(7);
    double[] values = random.doubles(400).toArray();
    Interval mean = Interval.bootstrap(values.length, drawn -> meanOf(values, drawn));
    double average = meanOf(values, IntStream.range(0, values.length).toArray());
    // The deviation of a mean of 400 uniform numbers is sqrt(1 / 12 / 400).
    double wide = 1.96 * Math.sqrt(1 / 12.0 / 400);
    assertEquals(average - wide, mean.low(), 0.1 * wide);
    assertEquals(average + wide, mean.high(), 0.1 * wide);
    assertEquals(mean, Interval.bootstrap(values.length, drawn -> meanOf(values, drawn)));
  }

  @Test
  void theBootstrapLeavesOutWhatIsNoNumber() {
    Interval some = Interval.bootstrap(2, drawn -> drawn[0] == drawn[1] ? Double.NaN : 5);
    assertEquals(new Interval(5, 5), some);
    assertTrue(Double.isNaN(Interval.bootstrap(2, drawn -> Double.NaN).low()));
  }

  private static double meanOf(double[] values, int[] drawn) {
    double sum = 0;
    for (int i : drawn) {
      sum += values[i];
    }
    return sum / drawn.length;
  }
}
