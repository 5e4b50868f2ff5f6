package glint.report;

import glint.report.Measurement.Cost;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Error against cost: the measurements of one scene, by growing numbers of samples.
 *
 * @param truth what the images were compared with
 * @param points at least one
 * @param truncation a bound on the error by bounces not followed, in display levels
 * @param complete whether all sample counts asked for were measured; else time ran out
 */
public record Curve(Truth truth, List<Measurement> points, double truncation, boolean complete) {

  /** Errors below this many display levels are the rounding of the values, and count as none. */
  public static final double NONE = 1e-6;

  /** The fewest points that tell a line from an accident. */
  private static final int FEWEST = 3;

  /** How many times as much as at the last point a sample may cost where it counts for a slope. */
  private static final double OVERHEAD = 2;

  /**
   * The line through the points.
   *
   * @param interval where its slope lies
   */
  public record Trend(PowerLaw law, Interval interval) {}

  /**
   * Fits error against cost. A single sample is left out, as it lies in the middle of its pixel
   * whatever the seed, and so are points without an error or a truth to trust, and those where a
   * sample costs more than twice as much as in the end: what starts a render counts there.
   *
   * @return nothing if fewer than three points remain
   */
  public Optional<Trend> trend(Cost cost) {
    double usual = perSample(points.get(points.size() - 1), cost);
    List<Measurement> used = new ArrayList<>();
    for (Measurement point : points) {
      if (point.samples() > 1
          && point.trusted()
          && point.error().levels() > NONE
          && perSample(point, cost) <= OVERHEAD * usual) {
        used.add(point);
      }
    }
    if (used.size() < FEWEST) {
      return Optional.empty();
    }
    int runs = used.get(0).runs().size();
    int[] all = new int[runs];
    for (int i = 0; i < runs; i++) {
      all[i] = i;
    }
    Interval interval = Interval.bootstrap(runs, drawn -> fit(used, cost, drawn).slope());
    return Optional.of(new Trend(fit(used, cost, all), interval));
  }

  private static double perSample(Measurement point, Cost cost) {
    return point.cost(cost) / point.samples();
  }

  private static PowerLaw fit(List<Measurement> points, Cost cost, int[] drawn) {
    double[] x = new double[points.size()];
    double[] y = new double[points.size()];
    for (int i = 0; i < x.length; i++) {
      List<Errors> runs = new ArrayList<>();
      for (int run : drawn) {
        runs.add(points.get(i).runs().get(run));
      }
      x[i] = points.get(i).cost(cost);
      // The floor keeps the logarithm finite where all runs drawn happen to be exact.
      y[i] = Math.max(Errors.together(runs).levels(), NONE);
    }
    return PowerLaw.fit(x, y);
  }
}
