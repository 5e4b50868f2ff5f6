package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Which hashes are one in so many. */
class OneInTest {

  @Property
  void thoseAreTheMultiples(@ForAll @IntRange(min = 1) int number, @ForAll long hash) {
    OneIn some = new OneIn(number);
    assertEquals(Long.remainderUnsigned(hash, number) == 0, some.takes(hash));
    assertTrue(some.takes(Long.divideUnsigned(hash, number) * number));
  }

  @Property
  void oneOfFewHashesIsTaken(@ForAll @IntRange(min = 1, max = 96) int number) {
    OneIn some = new OneIn(number);
    for (long hash = -2L * number; hash < 2L * number; hash++) {
      assertEquals(Long.remainderUnsigned(hash, number) == 0, some.takes(hash));
    }
  }
}
