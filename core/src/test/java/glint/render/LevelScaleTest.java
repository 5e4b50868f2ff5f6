package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.color.Transfer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LevelScaleTest {

  @ParameterizedTest
  @EnumSource
  void theTableIsWithinAHundredthOfALevel(Transfer transfer) {
    LevelScale scale = new LevelScale(transfer);
    for (int i = -100; i <= 20_000; i++) {
      double linear = i * 1e-4;
      assertEquals(transfer.level(linear), scale.level(linear), 0.01, () -> "at " + linear);
    }
    assertEquals(0, scale.level(Double.NaN));
    assertEquals(255, scale.level(Double.POSITIVE_INFINITY), 1e-9);
  }
}
