package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LevelScaleTest {

  @ParameterizedTest
  @EnumSource
  void theTableIsWithinAHundredthOfALevel(Transfer transfer) {
    LevelScale scale = LevelScale.of(transfer);
    for (int i = -100; i <= 20_000; i++) {
      double linear = i * 1e-4;
      assertEquals(transfer.level(linear), scale.level(linear), 0.01, () -> "at " + linear);
    }
    assertEquals(0, scale.level(Double.NaN));
    assertEquals(255, scale.level(Double.POSITIVE_INFINITY), 1e-9);
  }

  @ParameterizedTest
  @EnumSource(Transfer.class)
  void aRiseIsBoundedFromAboveAndHardlyTooHigh(Transfer transfer) {
    LevelScale scale = LevelScale.of(transfer);
    for (int i = 0; i < 100_000; i++) {
      double linear = i * 0.97e-5;
      double more = 1e-6 * (1 + i % 7);
      double exact = transfer.level(linear + more) - transfer.level(linear);
      double bound = scale.rise(linear, more);
      assertTrue(bound >= exact * (1 - 1e-9), linear + ": " + bound + " < " + exact);
      assertTrue(bound <= 1.05 * exact, linear + ": " + bound + " > " + exact);
    }
    assertEquals(0, scale.rise(1, 1e-3));
  }
}
