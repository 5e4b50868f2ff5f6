package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class OutlookTest {

  @Test
  void tilesTellHowLongAllOfItTakes() {
    Outlook outlook = new Outlook(1);
    assertEquals(Double.POSITIVE_INFINITY, outlook.left(3));
    assertEquals(0, outlook.done(3));
    outlook.tiles(0.25, 1);
    assertEquals(4 * 1.7 - 2, outlook.left(2), 1e-12);
    assertEquals(2 / 6.8, outlook.done(2), 1e-12);
  }

  /** An error of 8/√t comes down to 1 after 64 seconds. */
  @Test
  void anErrorThatFallsAsAPowerOfTheTimeIsForetoldExactly() {
    Outlook outlook = new Outlook(1);
    outlook.error(8, 1);
    outlook.error(4, 4);
    assertEquals(60, outlook.left(4), 1e-9);
    assertEquals(4 / 64.0, outlook.done(4), 1e-12);
    outlook.error(2, 16);
    assertEquals(48, outlook.left(16), 1e-9);
    outlook.error(0.9, 70);
    assertEquals(0, outlook.left(70), 1e-9);
    assertEquals(0.95, outlook.done(70));
  }

  @Test
  void theBarNeverGoesBack() {
    Outlook outlook = new Outlook(1);
    outlook.tiles(1, 10);
    double before = outlook.done(10);
    outlook.error(100, 11);
    assertTrue(outlook.left(11) > 1000);
    assertEquals(before, outlook.done(11));
  }

  @Test
  void anErrorOfZeroEndsIt() {
    Outlook outlook = new Outlook(1);
    outlook.error(0, 0);
    assertEquals(0.95, outlook.done(0));
    assertEquals(0, outlook.left(0));
    outlook.error(0, 2);
    assertEquals(0.95, outlook.done(3));
    assertEquals(0, outlook.left(3));
  }

  @Test
  void ofMoreThanTenHoursNothingIsSaid() {
    Outlook outlook = new Outlook(1);
    outlook.error(36_001, 1);
    assertEquals(36_000, outlook.left(1));
    outlook.error(36_001.1, 1);
    assertEquals(Double.POSITIVE_INFINITY, outlook.left(1));
    assertEquals(1 / 36_001.0, outlook.done(1), 1e-8);
  }

  @Test
  void whereAnyErrorWillDoTheFirstOneEndsIt() {
    Outlook outlook = new Outlook(Double.POSITIVE_INFINITY);
    outlook.error(100, 3);
    assertEquals(0, outlook.left(3));
    assertEquals(0.95, outlook.done(3));
  }
}
