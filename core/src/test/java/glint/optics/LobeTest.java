package glint.optics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.math.Rounding;
import java.math.BigDecimal;
import java.math.MathContext;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class LobeTest {

  @Property
  void wholePowersAreWithinTheirBound(
      @ForAll @DoubleRange(min = 0.6, max = 1) double cos,
      @ForAll @IntRange(min = 0, max = 1024) int n) {
    double exact = new BigDecimal(cos).pow(n, new MathContext(60)).doubleValue();
    assertEquals(exact, Lobe.of(cos, n), Rounding.gamma(n + 1) * exact + Double.MIN_NORMAL);
  }

  @Test
  void endsAndFractionsAreWhatTheyShouldBe() {
    assertEquals(1, Lobe.of(0, 0));
    assertEquals(0, Lobe.of(0, 7));
    assertEquals(0, Lobe.of(0, 0.5));
    assertEquals(1, Lobe.of(1, 1000));
    assertEquals(0.5, Lobe.of(0.25, 0.5), 1e-16);
    assertEquals(StrictMath.pow(0.999, 5000), Lobe.of(0.999, 5000));
  }
}
