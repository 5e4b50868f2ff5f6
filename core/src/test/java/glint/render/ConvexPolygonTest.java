package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

class ConvexPolygonTest {

  private static ConvexPolygon polygon(double... xy) {
    ConvexPolygon p = new ConvexPolygon();
    for (int i = 0; i < xy.length; i += 2) {
      p.add(xy[i], xy[i + 1]);
    }
    p.close();
    return p;
  }

  private static ConvexPolygon random(Random random, int points) {
    double[] xy = new double[2 * points];
    for (int i = 0; i < xy.length; i++) {
      xy[i] = 6 * random.nextDouble() - 1;
    }
    return polygon(xy);
  }

  @Test
  void aHullLeavesOutInnerAndCollinearPoints() {
    ConvexPolygon square = polygon(0, 0, 2, 2, 1, 1, 2, 0, 0, 2, 1, 0, 0, 0);
    assertEquals(4, square.count());
    assertEquals(4, square.area());
    assertEquals(2, square.width());
    assertTrue(square.contains(2, 1));
    assertFalse(square.contains(2.001, 1));
  }

  @Test
  void aPointOrALineIsEmpty() {
    assertTrue(polygon(1, 1).isEmpty());
    assertTrue(polygon(1, 1, 1, 1).isEmpty());
    assertTrue(polygon(0, 0, 1, 1, 3, 3).isEmpty());
    assertTrue(polygon().isEmpty());
  }

  @Test
  void widthIsTheLeastOfAllDirections() {
    assertEquals(Math.sqrt(0.5), polygon(0, 0, 1, 0, 0, 1).width(), 1e-15);
    assertEquals(0.1, polygon(0, 0, 30, 40, 30 - 0.08, 40 + 0.06, -0.08, 0.06).width(), 1e-12);
  }

  @Test
  void aLineCutsASpan() {
    double[] span = new double[2];
    ConvexPolygon triangle = polygon(0, 0, 4, 0, 0, 4);
    triangle.span(1, span);
    assertEquals(0, span[0]);
    assertEquals(3, span[1]);
    triangle.span(0, span);
    assertEquals(4, span[1]);
    triangle.span(5, span);
    assertTrue(span[0] > span[1]);
  }

  /** The cells of a grid share a polygon out. */
  @Property(tries = 200)
  void clippedPartsAddUp(@ForAll long seed) {
    ConvexPolygon whole = random(new Random(seed), 7);
    ConvexPolygon part = new ConvexPolygon();
    double sum = 0;
    for (int cell = 0; cell < 36; cell++) {
      int x = cell % 6 - 1;
      int y = cell / 6 - 1;
      part.clip(whole, x, y, x + 1, y + 1);
      sum += part.area();
    }
    assertEquals(whole.area(), sum, 1e-12);
  }

  /** Points of a square are in both of two polygons as often as their common area says. */
  @Property(tries = 50)
  void whatTwoHaveInCommonIsInBoth(@ForAll long seed) {
    Random random = new Random(seed);
    ConvexPolygon one = random(random, 5);
    ConvexPolygon two = random(random, 5);
    ConvexPolygon common = new ConvexPolygon();
    common.intersect(one, two);
    int both = 0;
    int n = 200;
    for (int i = 0; i < n * n; i++) {
      double x = (i % n + 0.5) * 6 / n - 1;
      int row = i / n;
      double y = (row + 0.5) * 6 / n - 1;
      both += one.contains(x, y) && two.contains(x, y) ? 1 : 0;
    }
    assertEquals(36.0 * both / (n * n), common.area(), 36 * 0.01);
  }

  /** Picks lie inside, and each half of a polygon gets its share. */
  @Property(tries = 50)
  void picksAreEven(@ForAll long seed) {
    ConvexPolygon whole = random(new Random(seed), 6);
    ConvexPolygon left = new ConvexPolygon();
    double middle = (whole.least(false) + whole.greatest(false)) / 2;
    left.clip(whole, -9, -9, middle, 9);
    int n = 100;
    int inLeft = 0;
    for (int i = 0; i < n * n; i++) {
      int row = i / n;
      whole.pick((i % n + 0.5) / n, (row + 0.5) / n);
      inLeft += whole.px <= middle ? 1 : 0;
      assertTrue(whole.px >= whole.least(false) && whole.py <= whole.greatest(true));
    }
    assertEquals(left.area() / whole.area(), (double) inLeft / (n * n), 0.02);
  }
}
