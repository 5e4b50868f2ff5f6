package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import java.util.Arrays;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;

/** A pixel divided by an edge. */
class SplitTest {

  /** Patterns of corners that two sides with different ends make, one for every pair of sides. */
  private static final long[][] PATTERNS = {
    {1, 2, 1, 2}, {1, 2, 2, 2}, {1, 2, 1, 1}, {1, 1, 2, 1}, {1, 1, 1, 2}, {1, 1, 2, 2},
  };

  private static final int STEPS = 4;

  @Property(tries = 300)
  void theMeanIsThatOfTheAreas(
      @ForAll @IntRange(max = 5) int pattern,
      @ForAll @IntRange(max = 15) int first,
      @ForAll @IntRange(max = 15) int second) {
    CornerGrid corners = corners(PATTERNS[pattern]);
    Split split = split(corners, first, second);
    split.look(0, 0, true);
    assertTrue(split.look(0, 0, split.agrees(true)));
    assertMeanIsOfAreas(split, PATTERNS[pattern]);
    assertEquals(corners.rgb[0], split.at(0, 0, 0), 1e-15);
    assertEquals(corners.rgb[3], split.at(0, 1, 0), 1e-15);
    assertEquals(corners.rgb[6], split.at(0, 0, 1), 1e-15);
    assertEquals(corners.rgb[9], split.at(0, 1, 1), 1e-15);
  }

  @Property(tries = 300)
  void theMeanIsThatOfTheAreasBesideAnArc(
      @ForAll @IntRange(max = 5) int pattern,
      @ForAll @DoubleRange(min = 0.05, max = 0.95) double first,
      @ForAll @DoubleRange(min = 0.05, max = 0.95) double second,
      @ForAll @DoubleRange(min = -0.2, max = 0.2) double bulge) {
    Split split = split(corners(PATTERNS[pattern]), 0, 0);
    split.freeze(0, 0, first, second, 0);
    double straight = split.mean(0);
    split.freeze(0, 0, first, second, bulge);
    LevelScale scale = LevelScale.of(Transfer.LINEAR);
    double doubt = Math.sqrt(3 * split.doubt(scale)) / 25.5;
    // What is left out of the mean, as it may leave the pixel, is doubtful; nothing is both.
    assertEquals(Math.abs(bulge), 10 * Math.abs(split.mean(0) - straight) + doubt, 1e-5);
    assertMeanIsOfAreas(split, PATTERNS[pattern]);
  }

  private static void assertMeanIsOfAreas(Split split, long[] pattern) {
    int n = 400;
    double sum = 0;
    for (int i = 0; i < n * n; i++) {
      int column = i % n;
      int row = i / n;
      sum += split.at(0, (column + 0.5) / n, (row + 0.5) / n);
    }
    assertEquals(sum / (n * n), split.mean(0), 0.1 * 2.0 / n, () -> Arrays.toString(pattern));
  }

  @Property(tries = 100)
  void theVarianceIsThatOfPlacesEvenInTheirBrackets(
      @ForAll @IntRange(max = 5) int pattern,
      @ForAll @IntRange(max = 15) int first,
      @ForAll @IntRange(max = 15) int second) {
    assertFinerOnesAgree(PATTERNS[pattern], first, second, STEPS, 0.02);
  }

  @Property(tries = 6)
  void ofSidesNeverDividedThoseCount(@ForAll @IntRange(max = 5) int pattern) {
    assertFinerOnesAgree(PATTERNS[pattern], 0, 0, 0, 0.08);
  }

  /**
   * Compares the mean and its variance with sixteen even places in each bracket, as if halved four
   * times more, of which those count that have the place looked at on the side where it was seen.
   */
  private static void assertFinerOnesAgree(
      long[] pattern, int first, int second, int steps, double share) {
    CornerGrid corners = corners(pattern);
    LevelScale scale = LevelScale.of(Transfer.LINEAR);
    Brackets brackets = new Brackets(corners, 0);
    for (boolean asCorner : new boolean[] {true, false}) {
      Split known = split(corners, first, second, steps);
      known.look(0, 0, asCorner);
      int count = 0;
      double sum = 0;
      double squares = 0;
      for (int i = 0; i < 256; i++) {
        Split finer = split(corners, first * 16 + i % 16, second * 16 + i / 16, steps + 4);
        finer.look(0, 0, asCorner);
        double inside = finer.at(0, brackets.insideX(0, 0), brackets.insideY(0, 0));
        if (Math.abs(inside - corners.rgb[0]) < 0.05 == asCorner) {
          count++;
          double error = 255 * (finer.mean(0) - known.mean(0));
          sum += error;
          squares += error * error;
        }
      }
      if (count >= 64) { // fewer are too coarse
        double bound = count == 256 ? share : 0.08;
        // A channel in three carries it; corners' areas are products of places, hence the band.
        double variance = squares / count;
        assertEquals(variance / 3, known.variance(scale), bound * variance + 1e-4);
        assertEquals(0, sum / count, 0.25 * Math.sqrt(variance));
      }
    }
  }

  private static CornerGrid corners(long[] signatures) {
    CornerGrid corners = new CornerGrid(1, 1, false, false);
    for (int i = 0; i < 4; i++) {
      corners.signature[i] = signatures[i];
      corners.rgb[3 * i] = signatures[i] == 1 ? 0.25 : 0.35;
    }
    return corners;
  }

  private static Split split(CornerGrid corners, int first, int second) {
    return split(corners, first, second, STEPS);
  }

  /** Places the crossings of the first two sides with different ends, in the order of numbers. */
  private static Split split(CornerGrid corners, int first, int second, int steps) {
    Brackets brackets = new Brackets(corners, 0);
    int[][] ends = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
    int found = 0;
    for (int i = 0; i < 4; i++) {
      if (corners.signature[ends[i][0]] != corners.signature[ends[i][1]]) {
        int at = brackets.open(brackets.sides.number(0, 0, i));
        brackets.steps[at] = (byte) steps;
        brackets.low[at] = Math.scalb((float) (found == 0 ? first : second), -steps);
        brackets.high[at] = Math.scalb((float) (found++ == 0 ? first : second) + 1, -steps);
      }
    }
    return new Split(corners, brackets);
  }
}
