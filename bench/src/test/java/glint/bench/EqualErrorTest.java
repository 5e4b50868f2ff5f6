package glint.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.bench.EqualError.Point;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

final class EqualErrorTest {

  private static final Point FAST = new Point("fast", 8, 1);
  private static final Point GOOD = new Point("good", 2, 4);
  private static final Point WASTE = new Point("waste", 3, 5);
  private static final Point BEST = new Point("best", 1, 32);

  private static final List<Point> POINTS = List.of(WASTE, BEST, FAST, GOOD);

  @Test
  void settingsThatOthersBeatInBothAreLeftOut() {
    assertEquals(List.of(FAST, GOOD, BEST), EqualError.best(POINTS));
    assertEquals(List.of(GOOD), EqualError.best(List.of(GOOD, GOOD)));
  }

  @Test
  void betweenSettingsSecondsFollowAPowerLaw() {
    assertEquals(2, EqualError.seconds(POINTS, 4).orElseThrow(), 1e-12);
    assertEquals(4 * Math.sqrt(8), EqualError.seconds(POINTS, Math.sqrt(2)).orElseThrow(), 1e-12);
    assertEquals(4, EqualError.seconds(POINTS, 2).orElseThrow(), 1e-12);
  }

  @Test
  void beyondThemTheFastestCountsOrNone() {
    assertEquals(OptionalDouble.of(1), EqualError.seconds(POINTS, 100));
    assertEquals(OptionalDouble.empty(), EqualError.seconds(POINTS, 0.5));
  }
}
