package glint.report;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ThinLinesTest {

  /** Of 60 lines of 20 to 40 pixels a known number of pixels is crossed, and few are missed. */
  @ParameterizedTest
  @CsvSource({"0.05, 0.1", "0.2, 0.02", "0.5, 0.001"})
  void fewPixelsMissALineThatCrossesThem(double width, double accepted) {
    ThinLines.Count count = ThinLines.count(width);
    // a line of length l crosses l (|cos| + |sin|) borders, 4/π of its length on average
    assertTrue(Math.abs(count.crossed() - 60 * (30 * 4 / Math.PI + 1)) < 200, count.toString());
    assertTrue(count.missed() <= accepted * count.crossed(), count.toString());
  }
}
