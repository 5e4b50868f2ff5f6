package glint.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import glint.image.Image;
import glint.report.Measurement.Cost;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Against uniform sampling that has 10/n levels at n ms and 1000 n rays. */
class PaceTest {

  private static Curve uniform() {
    List<Measurement> points = new ArrayList<>();
    for (int n = 1; n <= 16; n *= 2) {
      Errors one = new Errors(10.0 / n, 0, 0, 0);
      Rays rays = new Rays(1000.0 * n, 0, 0, 0);
      points.add(new Measurement(n, List.of(one, one), Spread.of(n * 1e-3), rays, true));
    }
    return new Curve(new Reference(new Image(1, 1), "known", 0, Transfer.LINEAR), points, 0, true);
  }

  private static TargetRuns runs(double one, double two) {
    Rays rays = new Rays(1500, 0, 0, 500);
    List<Errors> errors = List.of(new Errors(one, 0, 0, 0), new Errors(two, 0, 0, 0));
    return new TargetRuns(1, List.of(), errors, Spread.of(4e-3), rays, 2, 0);
  }

  @Test
  void atEqualErrorUniformSamplingIsInterpolated() {
    Pace pace = Pace.of(uniform(), runs(10 / 12.0, 10 / 12.0), Cost.SECONDS).orElseThrow();
    assertEquals(12, pace.samples(), 1e-9);
    assertTrue(pace.measured());
    assertEquals(3, pace.times(), 1e-9);
    assertEquals(3, pace.interval().low(), 1e-9);
    assertEquals(2.5, pace.errorAtCost(), 1e-9);
    assertEquals(6, Pace.of(uniform(), runs(10 / 12.0, 10 / 12.0), Cost.RAYS).get().times(), 1e-9);
  }

  @Test
  void beyondWhatWasMeasuredTheLawGoesOn() {
    Pace pace = Pace.of(uniform(), runs(10 / 40.0, 10 / 40.0), Cost.SECONDS).orElseThrow();
    assertEquals(40, pace.samples(), 1e-9);
    assertFalse(pace.measured());
    assertEquals(10, pace.times(), 1e-9);
  }

  @Test
  void aSingleSampleMayBeEnough() {
    assertEquals(1, Pace.of(uniform(), runs(30, 30), Cost.RAYS).orElseThrow().samples());
  }

  @Test
  void runsThatDifferMakeAnInterval() {
    Interval interval = Pace.of(uniform(), runs(2.5, 1.25), Cost.RAYS).orElseThrow().interval();
    assertEquals(2, interval.low(), 1e-9);
    assertEquals(4, interval.high(), 1e-9);
  }
}
