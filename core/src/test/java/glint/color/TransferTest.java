package glint.color;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TransferTest {

  @ParameterizedTest
  @CsvSource({
    "0, 0, 0",
    "1, 255, 255",
    "0.5, 188, 187.516",
    "0.25, 137, 136.960",
    "0.18, 118, 117.646"
  })
  void encodesLinearLightAsSrgb(double linear, int code, double level) {
    assertEquals(code, Transfer.SRGB.code(linear));
    assertEquals(level, Transfer.SRGB.level(linear), 5e-4);
  }

  @Test
  void everySrgbCodeSurvivesTheWayThroughLinearLight() {
    for (int code = 0; code < 256; code++) {
      assertEquals(code, Transfer.SRGB.code(Transfer.SRGB.decode(code / 255.0)));
    }
  }

  @Test
  void everyLinearCodeSurvivesTheWayThroughLinearLight() {
    for (int code = 0; code < 256; code++) {
      assertEquals(code, Transfer.LINEAR.code(Transfer.LINEAR.decode(code / 255.0)));
    }
  }

  @Test
  void decodeUndoesEncode() {
    for (int i = 0; i <= 1000; i++) {
      double linear = i / 1000.0;
      assertEquals(linear, Transfer.SRGB.decode(Transfer.SRGB.encode(linear)), 1e-15);
    }
  }

  @Test
  void srgbCurveRises() {
    double last = -1;
    for (int i = 0; i <= 10_000; i++) {
      double encoded = Transfer.SRGB.encode(i * 1e-6); // passes the joint of the two pieces
      assertTrue(encoded > last);
      last = encoded;
    }
  }

  @Test
  void linearCodesAreRoundedDown() {
    assertEquals(127, Transfer.LINEAR.code(0.5));
    assertEquals(254, Transfer.LINEAR.code(0.999999));
    assertEquals(255, Transfer.LINEAR.code(1));
    assertEquals(127.5, Transfer.LINEAR.level(0.5));
  }

  @Test
  void valuesOutsideTheDisplayAreClamped() {
    for (Transfer transfer : Transfer.values()) {
      assertEquals(0, transfer.code(-0.5));
      assertEquals(0, transfer.code(Double.NaN));
      assertEquals(255, transfer.code(7));
      assertEquals(255, transfer.code(Double.POSITIVE_INFINITY));
      assertEquals(0, transfer.level(Double.NEGATIVE_INFINITY));
    }
  }
}
