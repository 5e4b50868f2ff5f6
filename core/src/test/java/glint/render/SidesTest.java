package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.HashSet;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** The numbers of sides. */
class SidesTest {

  /** Which corners each side of a pixel joins: 0 top, 1 bottom, 2 left, 3 right. */
  private static final int[][] ENDS = {{0, 0, 1, 0}, {0, 1, 1, 1}, {0, 0, 0, 1}, {1, 0, 1, 1}};

  @Property(tries = 50)
  void everySideJoinsItsTwoCorners(
      @ForAll @IntRange(min = 1, max = 9) int width,
      @ForAll @IntRange(min = 1, max = 9) int height) {
    CornerGrid corners = new CornerGrid(width, height, false, false);
    Sides sides = new Sides(corners);
    Set<Integer> numbers = new HashSet<>();
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        assertEquals(sides.top(x, y), sides.number(x, y, 0));
        assertEquals(sides.left(x, y), sides.number(x, y, 2));
        for (int i = 0; i < 4; i++) {
          int number = sides.number(x, y, i);
          int[] ends = ENDS[i];
          numbers.add(number);
          assertEquals((y + ends[1]) * corners.stride + x + ends[0], sides.first(number));
          assertEquals((y + ends[3]) * corners.stride + x + ends[2], sides.last(number));
          assertEquals(i < 2, sides.isHorizontal(number));
          assertEquals(x + (i == 3 ? 1 : 0), sides.column(number));
          assertEquals(y + (i == 1 ? 1 : 0), sides.row(number));
        }
      }
    }
    assertEquals(sides.count, numbers.size());
  }
}
