package glint.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.image.Image;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Statistics;
import glint.report.Measurement.Cost;
import glint.scene.Expectation;
import glint.trace.RayCounts;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Studies of a renderer whose errors and times follow a law. */
class StudyTest {

  private static final double PER_SAMPLE = 1e-3;
  private static final long SEED = 5;

  private final List<RenderSettings> asked = new ArrayList<>();

  /** A grey pixel of 0.5, off by ±0.2 n^-0.75: up for even seeds, down for odd ones. */
  private RenderResult render(RenderSettings settings) {
    asked.add(settings);
    int n = settings.samples();
    Image image = new Image(1, 1);
    double error = 0.2 * Math.pow(n, -0.75);
    double v = settings.seed() % 2 == 0 ? 0.5 + error : 0.5 - error;
    image.set(0, 0, v, v, v);
    RayCounts rays = new RayCounts();
    rays.camera = n;
    rays.shadow = 2L * n + settings.seed() % 2;
    Statistics statistics =
        new Statistics(rays, n, n, n, 1, 0, 0, -1, 0, Double.NaN, 0.03, PER_SAMPLE * n);
    return new RenderResult(image, Map.of(), statistics);
  }

  private Curve study(int most, double limit, Truth truth) {
    RenderSettings settings =
        new RenderSettings(1, 1, 16, SEED, OptionalInt.empty(), 1, 8, Set.of());
    return new Study(this::render, settings, most, limit).run(truth);
  }

  private static Truth half() {
    Expectation mean =
        new Expectation(Optional.empty(), Rgb.grey(0.5), 0, 0, 16, OptionalInt.empty());
    return new Answers(List.of(mean), Transfer.LINEAR);
  }

  @Test
  void everyPowerOfTwoIsMeasured() {
    Curve curve = study(1024, 1e9, half());
    assertTrue(curve.complete());
    assertEquals(0.03, curve.truncation());
    assertEquals(11, curve.points().size());
    for (int i = 0; i < 11; i++) {
      Measurement point = curve.points().get(i);
      double n = 1 << i;
      assertEquals(1 << i, point.samples());
      assertEquals(Study.RUNS, point.runs().size());
      assertEquals(255 * 0.2 * Math.pow(n, -0.75), point.error().levels(), 1e-10);
      assertEquals(PER_SAMPLE * n, point.cost(Cost.SECONDS), 1e-12);
      assertEquals(3 * n + 0.5, point.cost(Cost.RAYS), 1e-9);
      assertEquals(2 * n + 0.5, point.rays().shadow(), 1e-9);
      assertTrue(point.trusted());
    }
  }

  @Test
  void theTrendIsTheLawWithoutTheSingleSample() {
    Curve.Trend trend = study(1024, 1e9, half()).trend(Cost.SECONDS).orElseThrow();
    assertEquals(-0.75, trend.law().slope(), 1e-9);
    assertEquals(255 * 0.2 * Math.pow(PER_SAMPLE, 0.75), trend.law().factor(), 1e-9);
    assertEquals(-0.75, trend.interval().low(), 1e-9);
    assertEquals(-0.75, trend.interval().high(), 1e-9);
    assertTrue(study(8, 1e9, half()).trend(Cost.RAYS).isPresent());
    assertTrue(study(4, 1e9, half()).trend(Cost.RAYS).isEmpty());
  }

  @Test
  void theTrendOfRunsThatDifferIsUncertain() {
    Curve.Trend trend = law(4, true).trend(Cost.RAYS).orElseThrow();
    // Of the last point the draws make 1/16, 4/16, or the root mean square of both.
    assertEquals(-1, trend.interval().low(), 1e-12);
    assertEquals(-1 + 3 * 2 / 10.0, trend.interval().high(), 1e-12);
    assertTrue(trend.law().slope() > -1 && trend.law().slope() < -0.4);
    // Where all runs that are drawn have no error, it counts as the least that is one.
    Interval steep = law(0, true).trend(Cost.RAYS).orElseThrow().interval();
    assertEquals(-1 + 3 * Math.log(16 * Curve.NONE) / Math.log(2) / 10, steep.low(), 1e-12);
  }

  @Test
  void theTrendLeavesOutWhatIsNotToBeTrusted() {
    Curve.Trend trend = law(4, false).trend(Cost.RAYS).orElseThrow();
    assertEquals(-1, trend.law().slope(), 1e-12);
    assertEquals(-1, trend.interval().high(), 1e-12);
  }

  /**
   * Two runs whose error is 1/n for n rays, but that of the last point's second is more or less.
   */
  private static Curve law(double lastTimes, boolean lastTrusted) {
    List<Measurement> points = new ArrayList<>();
    for (int n = 2; n <= 16; n *= 2) {
      boolean last = n == 16;
      Errors one = new Errors(1.0 / n, 0, 0, 0);
      Errors two = new Errors(last ? lastTimes / n : 1.0 / n, 0, 0, 0);
      Rays rays = new Rays(n, 0, 0, 0);
      boolean trusted = lastTrusted || !last;
      points.add(new Measurement(n, List.of(one, two), Spread.of(n), rays, trusted));
    }
    return new Curve(half(), points, 0, true);
  }

  @Test
  void timesOfStartingAreLeftOut() {
    List<Measurement> points = new ArrayList<>();
    for (int n = 1; n <= 128; n *= 2) {
      // Starting takes as long as 10 samples, and so up to 8 samples more than twice 138/128 each.
      Spread seconds = Spread.of(10 + n);
      Errors error = new Errors(n < 16 ? 1 : 1.0 / (10 + n), 0, 0, 0);
      points.add(new Measurement(n, List.of(error), seconds, new Rays(n, 0, 0, 0), true));
    }
    Curve curve = new Curve(half(), points, 0, true);
    assertEquals(-1, curve.trend(Cost.SECONDS).orElseThrow().law().slope(), 1e-12);
    assertNotEquals(-1, curve.trend(Cost.RAYS).orElseThrow().law().slope(), 0.1);
    Curve shorter = new Curve(half(), points.subList(0, 3), 0, true);
    assertTrue(shorter.trend(Cost.SECONDS).isEmpty());
  }

  @Test
  void exactImagesHaveNoTrend() {
    List<Measurement> points = new ArrayList<>();
    for (int n = 1; n <= 64; n *= 2) {
      Errors none = new Errors(n < 4 ? 1 : 1e-9, 0, 0, 0);
      points.add(new Measurement(n, List.of(none), Spread.of(n), new Rays(n, 0, 0, 0), true));
    }
    assertTrue(new Curve(half(), points, 0, true).trend(Cost.RAYS).isEmpty());
  }

  @Test
  void theTimeEndsTheDoubling() {
    // 8 runs of 1, 2 and 4 samples take 0.056 s, and those of 8 would take 0.064 s more.
    Curve curve = study(1024, 0.1, half());
    assertFalse(curve.complete());
    assertEquals(List.of(1, 2, 4), samples(curve));
    double spent = asked.stream().mapToDouble(s -> PER_SAMPLE * s.samples()).sum();
    assertTrue(spent <= 0.1, () -> "took " + spent);
    assertEquals(List.of(1), samples(study(1024, 0.001, half())));
    assertFalse(study(8, 0.1, half()).complete());
    assertTrue(study(4, 0.1, half()).complete());
  }

  @Test
  void whatTheTruthIsTooCoarseForIsNotTrusted() {
    Image grey = new Image(1, 1);
    grey.set(0, 0, 0.5, 0.5, 0.5);
    double uncertainty = 255 * 0.2 * Math.pow(640, -0.75);
    Curve curve = study(40, 1e9, new Reference(grey, "known", uncertainty, Transfer.LINEAR));
    // Errors of at least ten times as much are claimed: up to 640 / 10^(4/3) = 29.7 samples.
    for (Measurement point : curve.points()) {
      assertEquals(point.samples() < 29, point.trusted(), () -> "at " + point.samples());
    }
    Curve.Trend trend = curve.trend(Cost.SECONDS).orElseThrow();
    assertEquals(-0.75, trend.law().slope(), 1e-9);
    List<Long> seeds = asked.stream().map(RenderSettings::seed).distinct().sorted().toList();
    assertEquals(SEED, seeds.get(0));
    assertEquals(SEED + Study.RUNS - 1, seeds.get(seeds.size() - 1));
  }

  private static List<Integer> samples(Curve curve) {
    return curve.points().stream().map(Measurement::samples).toList();
  }
}
