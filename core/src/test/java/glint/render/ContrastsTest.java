package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Contrasts are variances, whatever rows were asked for before. */
class ContrastsTest {

  @ParameterizedTest
  @CsvSource({"1, 1", "1, 7", "2, 2", "3, 1", "4, 3", "9, 12", "32, 5"})
  void contrastsAreVariances(int width, int height) {
    CornerGrid corners = new CornerGrid(width, height, false, false);
    Random random = new Random(width * 100 + height);
    for (int i = 0; i < corners.levels.length; i++) {
      corners.levels[i] = 255 * random.nextFloat();
    }
    Contrasts contrasts = new Contrasts(corners, corners.levels);
    float[] out = new float[width + 1];
    for (int turn = 0; turn < 40; turn++) {
      int y = turn < height ? turn : random.nextInt(height);
      contrasts.find(y, out, 1);
      for (int x = 0; x < width; x++) {
        assertEquals(variance(corners, x, y), out[x + 1], 0.01, "pixel " + x + ", " + y);
      }
    }
  }

  /** The mean over channels of the mean square of the differences from the mean. */
  private static double variance(CornerGrid corners, int x, int y) {
    double all = 0;
    for (int channel = 0; channel < 3; channel++) {
      double mean = mean(corners, x, y, channel, 0);
      all += mean(corners, x, y, channel, mean) / 3;
    }
    return all;
  }

  /** The mean level, or the mean square of the difference from one that is not 0. */
  private static double mean(CornerGrid corners, int x, int y, int channel, double from) {
    double sum = 0;
    int count = 0;
    for (int row = Math.max(0, y - 1); row <= Math.min(corners.rows - 1, y + 2); row++) {
      for (int column = Math.max(0, x - 1);
          column <= Math.min(corners.stride - 1, x + 2);
          column++) {
        double level = corners.levels[3 * (row * corners.stride + column) + channel];
        sum += from == 0 ? level : (level - from) * (level - from);
        count++;
      }
    }
    return sum / count;
  }
}
