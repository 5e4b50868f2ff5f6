package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.io.EarClipper.Outcome;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A polygon of n corners is covered once by n - 2 triangles. */
class TriangulatorTest {

  /** What a polygon was divided into: signed areas in units of the exact shoelace formula. */
  private record Division(Outcome outcome, List<BigDecimal> twiceAreas) {

    BigDecimal sum() {
      return twiceAreas.stream().reduce(BigDecimal.ZERO, BigDecimal::add);
    }

    long flat() {
      return twiceAreas.stream().filter(a -> a.signum() == 0).count();
    }

    long reversed() {
      return twiceAreas.stream().filter(a -> a.signum() < 0).count();
    }
  }

  /** Divides a polygon of the plane z = 0, which must run counter-clockwise. */
  private static Division divide(double... xy) {
    int n = xy.length / 2;
    double[] points = new double[3 * n];
    for (int i = 0; i < n; i++) {
      points[3 * i] = xy[2 * i];
      points[3 * i + 1] = xy[2 * i + 1];
    }
    Triangulator triangulator = new Triangulator();
    Outcome outcome = triangulator.divide(points, n);
    List<BigDecimal> areas = new ArrayList<>();
    int[] uses = new int[n];
    for (int i = 0; i < 3 * (n - 2) && outcome != Outcome.GIVEN_UP; i += 3) {
      int[] t = {triangulator.corner(i), triangulator.corner(i + 1), triangulator.corner(i + 2)};
      Arrays.stream(t).forEach(c -> uses[c]++);
      double[] three = {
        xy[2 * t[0]],
        xy[2 * t[0] + 1],
        xy[2 * t[1]],
        xy[2 * t[1] + 1],
        xy[2 * t[2]],
        xy[2 * t[2] + 1]
      };
      areas.add(Polygons.twiceArea(three));
    }
    assertTrue(Arrays.stream(uses).allMatch(u -> u > 0 || outcome == Outcome.GIVEN_UP));
    return new Division(outcome, areas);
  }

  /** All triangles have the polygon's side and an area, and together exactly the polygon's. */
  private static void checkSimple(double... xy) {
    Division d = divide(xy);
    String polygon = Arrays.toString(xy);
    assertEquals(Outcome.DIVIDED, d.outcome(), polygon);
    assertEquals(xy.length / 2 - 2, d.twiceAreas().size(), polygon);
    assertEquals(0, d.reversed(), polygon);
    assertEquals(0, d.flat(), polygon);
    assertEquals(0, Polygons.twiceArea(xy).compareTo(d.sum()), polygon);
  }

  /** The same from every corner on, and mirrored. */
  private static void checkAllWays(double... xy) {
    int n = xy.length / 2;
    for (int start = 0; start < n; start++) {
      double[] turned = new double[2 * n];
      double[] mirrored = new double[2 * n];
      for (int i = 0; i < n; i++) {
        int from = (start + i) % n;
        turned[2 * i] = xy[2 * from];
        turned[2 * i + 1] = xy[2 * from + 1];
        mirrored[2 * (n - 1 - i)] = -xy[2 * from];
        mirrored[2 * (n - 1 - i) + 1] = xy[2 * from + 1];
      }
      checkSimple(turned);
      checkSimple(mirrored);
    }
  }

  @Test
  void knownShapes() {
    checkAllWays(0, 0, 1, 0, 1, 1, 0, 1); // square
    checkAllWays(0, 0, 2, 0, 2, 2, 1, .5); // dart
    checkAllWays(0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2); // L
    checkAllWays(0, 0, 5, 0, 5, 3, 4, 3, 4, 1, 3, 1, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3); // comb
    checkAllWays(0, 0, 4, 1, 8, 0, 7, 4, 8, 8, 4, 7, 0, 8, 1, 4); // four-pointed star
    checkAllWays(1, 0, 0, 3, -1, 0, -3, -.25, 0, -1.5, 3, -.25); // arrow
  }

  @Test
  void cornersOnStraightEdges() {
    checkAllWays(0, 0, 1, 0, 2, 0, 0, 2); // triangle
    checkAllWays(0, 0, 1, 0, 2, 0, 3, 0, 3, 3, 2, 2, 1, 1);
    checkAllWays(0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1); // square
    checkAllWays(0, 0, .1, 0, .2, 0, .3, 0, .4, 0, .4, .7, .3, .7, .2, .7, .1, .7, 0, .7);
    checkAllWays(0, 0, 4, 0, 4, 4, 3, 4, 3, 3, 2, 3, 1, 3, 1, 4, 0, 4, 0, 2); // U
    // An ear's third side must not touch a corner: (2, 2) lies on the diagonal of the square.
    checkAllWays(0, 0, 4, 0, 4, 4, 2, 2, 0, 4);
  }

  @Test
  void spiral() {
    List<Double> outer = new ArrayList<>();
    List<Double> inner = new ArrayList<>();
    for (int i = 0; i < 400; i++) {
      double angle = i * 0.1;
      outer.addAll(List.of((angle + 3) * Math.cos(angle), (angle + 3) * Math.sin(angle)));
      inner.addAll(0, List.of((angle + 1) * Math.cos(angle), (angle + 1) * Math.sin(angle)));
    }
    outer.addAll(inner);
    checkSimple(outer.stream().mapToDouble(v -> v).toArray());
  }

  /** Corners at random angles and distances around a point, in order of their angle. */
  @Test
  void randomStars() {
    Random random = new Random(51);
    for (int round = 0; round < 2000; round++) {
      int n = 4 + random.nextInt(round % 20 == 0 ? 200 : 12);
      double[] angles = random.doubles(n).sorted().toArray();
      double[] xy = new double[2 * n];
      for (int i = 0; i < n; i++) {
        double r = 0.1 + random.nextDouble();
        // Whole multiples of a power of two: corners on lines and on each other's lines
        double grid = round % 3 == 0 ? 16 : 0x1p20;
        double angle = 2 * Math.PI * (i + 0.9 * angles[i]) / n;
        xy[2 * i] = Math.rint(r * Math.cos(angle) * grid) / grid;
        xy[2 * i + 1] = Math.rint(r * Math.sin(angle) * grid) / grid;
      }
      if (Polygons.isSimple(xy) && Polygons.twiceArea(xy).signum() > 0) {
        checkSimple(xy);
      }
    }
  }

  /** Random corners on a grid, their crossings undone one by one until the polygon is simple. */
  @Test
  void randomSimplePolygons() {
    Random random = new Random(52);
    int simple = 0;
    for (int round = 0; round < 1500; round++) {
      int n = 4 + random.nextInt(14);
      int grid = round % 2 == 0 ? 8 : 1 << 20;
      double[] xy = random.ints(2L * n, 0, grid).asDoubleStream().toArray();
      Polygons.untangle(xy);
      if (Polygons.isSimple(xy)) {
        simple++;
        checkSimple(Polygons.twiceArea(xy).signum() > 0 ? xy : Polygons.reversed(xy));
      }
    }
    assertTrue(simple > 1000, "only " + simple);
  }

  /** Holes as modellers write them: a bridge leads to the hole and, on the same edge, back. */
  @Test
  void holesBehindBridges() {
    checkSimple(0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 1, 1, 1, 3, 3, 3, 3, 1, 1, 1);
    checkSimple(
        0, 0, 9, 0, 9, 9, 0, 9, 0, 5, 3, 5, 3, 6, 4, 6, 4, 5, 3, 5, 0, 5, 0, 2, 5, 2, 5, 3, 6, 3, 6,
        2, 5, 2, 0, 2);
    // A hole that touches the border from inside
    checkSimple(0, 0, 2, 0, 1, 2, 3, 2, 2, 0, 4, 0, 4, 4, 0, 4);
  }

  @Test
  void spikesAndDoublePointsAreFlatTriangles() {
    Division d = divide(0, 0, 2, 0, 2, 2, 3, 3, 2, 2, 0, 2);
    assertEquals(4, d.twiceAreas().size());
    assertEquals(0, BigDecimal.valueOf(8).compareTo(d.sum()));
    assertEquals(0, d.reversed());
    d = divide(0, 0, 1, 0, 1, 0, 2, 0, 2, 2, 2, 2, 1, 1, 0, 2);
    assertEquals(6, d.twiceAreas().size());
    assertEquals(0, Polygons.twiceArea(0, 0, 2, 0, 2, 2, 1, 1, 0, 2).compareTo(d.sum()));
    assertEquals(0, d.reversed());
  }

  @Test
  void crossingEdgesAreSeen() {
    // A pentagram turns the same way at every corner, but goes round twice.
    double[] star = new double[10];
    for (int i = 0; i < 5; i++) {
      star[2 * i] = Math.cos(0.8 * Math.PI * i);
      star[2 * i + 1] = Math.sin(0.8 * Math.PI * i);
    }
    assertEquals(3, divide(star).twiceAreas().size());
    assertEquals(2, divide(0, 0, 0, 0, 0, 0, 0, 0).twiceAreas().size());
    assertEquals(2, divide(0, 0, 1, 1, 2, 2, 3, 3).twiceAreas().size());
  }

  /** In every plane of space, to within the rounding of the shear into an axis plane. */
  @Test
  void everyPlane() {
    double[] xy = {0, 0, 5, 0, 5, 3, 4, 3, 4, 1, 3, 1, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3};
    Random random = new Random(53);
    for (int round = 0; round < 500; round++) {
      double[] u = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
      double[] v = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
      double[] o = {
        9 * random.nextGaussian(), 9 * random.nextGaussian(), 9 * random.nextGaussian()
      };
      double[] points = new double[36];
      for (int i = 0; i < 36; i++) {
        points[i] = o[i % 3] + xy[i / 3 * 2] * u[i % 3] + xy[i / 3 * 2 + 1] * v[i % 3];
      }
      Triangulator t = new Triangulator();
      assertEquals(Outcome.DIVIDED, t.divide(points, 12));
      double sum = 0;
      for (int i = 0; i < 30; i += 3) {
        double[] three = new double[6];
        for (int j = 0; j < 3; j++) {
          three[2 * j] = xy[2 * t.corner(i + j)];
          three[2 * j + 1] = xy[2 * t.corner(i + j) + 1];
        }
        double area = Polygons.twiceArea(three).doubleValue();
        // Corners that lay on a line before the shear may make a triangle of no area
        assertTrue(area >= 0, "round " + round);
        sum += area;
      }
      assertEquals(22, sum, "round " + round);
    }
  }

  /**
   * A large polygon takes bounded time: if all of it would have to be looked at, it is given up.
   */
  @Test
  @Timeout(value = 2, unit = TimeUnit.MINUTES) // a hang, not a speed
  void largePolygons() {
    int n = 100_000;
    double[] gear = new double[2 * n];
    double[] comb = new double[2 * n];
    double[] noise = new Random(54).doubles(40_000).toArray();
    for (int i = 0; i < n; i++) {
      double r = i % 4 < 2 ? 1 : 0.999;
      gear[2 * i] = r * Math.cos(2 * Math.PI * i / n);
      gear[2 * i + 1] = r * Math.sin(2 * Math.PI * i / n);
      comb[2 * i] = i < n - 1 ? (i % 2) * 1e6 : -1;
      comb[2 * i + 1] = i < n - 1 ? i : n;
    }
    Division d = divide(gear);
    assertEquals(Outcome.DIVIDED, d.outcome());
    assertEquals(n - 2, d.twiceAreas().size());
    assertEquals(0, d.reversed());
    assertEquals(0, Polygons.twiceArea(gear).compareTo(d.sum()));
    assertEquals(Outcome.GIVEN_UP, divide(comb).outcome());
    assertEquals(Outcome.CROSSED, divide(noise).outcome());
  }
}
