package glint.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SobolSamplerTest {

  /** Any first 2^k points: one in every cell of every 2^i by 2^(k-i) grid. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 4, 7, 10})
  void everyElementaryIntervalHoldsItsShare(int k) {
    SobolSampler sampler = new SobolSampler(42);
    for (int pixel = 0; pixel < 20; pixel++) {
      sampler.pixel(pixel, 3 * pixel);
      for (int i = 0; i <= k; i++) {
        boolean[] seen = new boolean[1 << k];
        for (int index = 0; index < 1 << k; index++) {
          sampler.sample(index);
          int column = (int) (sampler.x * (1 << i));
          int row = (int) (sampler.y * (1 << (k - i)));
          int cell = row << i | column;
          assertTrue(!seen[cell], "two of 2^" + k + " points share a cell");
          seen[cell] = true;
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {0, 1, -5})
  void firstPointsSpreadEvenlyOverPixels(long seed) {
    SobolSampler sampler = new SobolSampler(seed);
    double sumX = 0;
    double sumY = 0;
    double product = 0;
    int side = 300;
    for (int y = 0; y < side; y++) {
      for (int x = 0; x < side; x++) {
        sampler.pixel(x, y);
        sampler.sample(0);
        sumX += sampler.x - 0.5;
        sumY += sampler.y - 0.5;
        product += (sampler.x - 0.5) * (sampler.y - 0.5);
      }
    }
    // Four standard errors of the mean of uniform numbers, and of the product of two.
    int n = side * side;
    assertEquals(0, sumX / n, 4 * Math.sqrt(1.0 / 12 / n));
    assertEquals(0, sumY / n, 4 * Math.sqrt(1.0 / 12 / n));
    assertEquals(0, product / n, 4.0 / 12 / Math.sqrt(n));
  }
}
