package glint.color;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

class SrgbCodesTest {

  @Test
  void codesAreThoseOfTheCurveWhereTheyChangeAndAnywhere() {
    int last = 0;
    for (int i = 0; i <= 1 << 16; i++) {
      double v = (double) i / (1 << 16);
      check(v);
      int code = SrgbCodes.of(v);
      if (code != last) {
        assertEquals(last + 1, code);
        double low = (double) (i - 1) / (1 << 16);
        while (Math.nextUp(low) < v) {
          double middle = low + (v - low) / 2;
          if (SrgbCodes.byCurve(middle) == code) {
            v = middle;
          } else {
            low = middle;
          }
        }
        for (int j = 0; j < 4; j++) {
          check(low);
          check(v);
          low = Math.nextDown(low);
          v = Math.nextUp(v);
        }
        last = code;
      }
    }
    assertEquals(255, last);
    Random random = new Random(1);
    for (int i = 0; i < 100_000; i++) {
      check(random.nextDouble());
      check(random.nextDouble() / (1 << random.nextInt(20)));
    }
    check(0);
    check(Double.MIN_VALUE);
    check(1);
  }

  private static void check(double linear) {
    assertEquals(SrgbCodes.byCurve(linear), SrgbCodes.of(linear), () -> "of " + linear);
  }
}
