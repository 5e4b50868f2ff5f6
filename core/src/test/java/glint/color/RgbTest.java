package glint.color;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.BadValueException;
import org.junit.jupiter.api.Test;

class RgbTest {

  @Test
  void addsAndMultipliesByComponent() {
    Rgb c = new Rgb(0.25, 0.5, 2);
    assertEquals(new Rgb(0.5, 1.5, 2.5), c.plus(new Rgb(0.25, 1, 0.5)));
    assertEquals(new Rgb(0.5, 0.25, 0), c.times(new Rgb(2, 0.5, 0)));
    assertEquals(new Rgb(0.5, 1, 4), c.times(2));
    assertEquals(2, c.max());
  }

  @Test
  void onlyThreeZerosAreBlack() {
    assertTrue(new Rgb(0, -0.0, 0).isBlack());
    assertFalse(new Rgb(0, 0, Double.MIN_VALUE).isBlack());
    assertFalse(new Rgb(Double.NaN, 0, 0).isBlack());
  }

  @Test
  void lightIsFiniteAndNotNegative() {
    Rgb.BLACK.requireLight("color");
    Rgb.grey(Double.MAX_VALUE).requireLight("color");
    new Rgb(-0.0, 0, 1).requireLight("color");
    double[] bad = {Double.NaN, Double.POSITIVE_INFINITY, -Double.MIN_VALUE};
    for (double v : bad) {
      assertThrows(BadValueException.class, () -> new Rgb(v, 1, 1).requireLight("color"));
      assertThrows(BadValueException.class, () -> new Rgb(1, v, 1).requireLight("color"));
      assertThrows(BadValueException.class, () -> new Rgb(1, 1, v).requireLight("color"));
    }
  }
}
