package glint.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

class SignatureTest {

  /** The first surface in the light of the first light, and out of it: both have the number 0. */
  @Test
  void thingsWithTheNumberZeroAreMet() {
    Set<Long> values = new HashSet<>();
    Signature signature = new Signature();
    for (int i = 0; i < 1000; i++) {
      assertTrue(values.add(signature.value()), "different after " + i + " zeros");
      signature.add(0);
    }
  }

  @Property
  void listsOfThingsDifferIfAndOnlyIfTheirSignaturesDo(
      @ForAll @Size(max = 6) List<@IntRange(min = -3, max = 3) Integer> one,
      @ForAll @Size(max = 6) List<@IntRange(min = -3, max = 3) Integer> two) {
    assertEquals(one.equals(two), signature(one) == signature(two));
  }

  private static long signature(List<Integer> things) {
    Signature signature = new Signature();
    signature.clear();
    things.forEach(signature::add);
    return signature.value();
  }
}
