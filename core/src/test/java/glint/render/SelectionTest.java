package glint.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;

/** Numbers, each chosen once. */
class SelectionTest {

  @Property(tries = 200)
  void numbersStandOnceInTheOrderOfTheirChoice(
      @ForAll @Size(max = 3000) List<@IntRange(max = 9000) Integer> numbers) {
    Selection selection = new Selection();
    for (int again = 0; again < 2; again++) {
      Set<Integer> expected = new LinkedHashSet<>();
      for (int number : numbers) {
        expected.add(number);
        selection.add(number);
      }
      int[] all = expected.stream().mapToInt(Integer::intValue).toArray();
      assertEquals(all.length == 0, selection.isEmpty());
      assertArrayEquals(all, selection.list());
      assertArrayEquals(all, selection.take());
      assertTrue(selection.isEmpty());
      assertArrayEquals(new int[0], selection.take());
    }
  }

  @Property(tries = 10)
  void manyNumbersFit(@ForAll @IntRange(min = 1, max = 100_000) int count) {
    Selection selection = new Selection();
    for (int i = count - 1; i >= 0; i--) {
      selection.add(i);
      selection.add(i);
    }
    assertEquals(count, selection.list().length);
  }
}
