package glint.report;

import glint.report.Measurement.Cost;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Renders to an error beside uniform sampling.
 *
 * @param samples uniform samples that reach the same error, interpolated, or beyond what was
 *     measured by the law of the last doubling
 * @param measured whether so many were measured
 * @param times how many times as much these cost: the ratio of efficiencies at equal error
 * @param interval where that lies, by a bootstrap over the runs of both
 * @param errorAtCost the error of uniform sampling at equal cost, in display levels
 */
public record Pace(
    double samples, boolean measured, double times, Interval interval, double errorAtCost) {

  /** The logarithm by which errors of random samples fall with every doubling: √2. */
  private static final double LEAST_FALL = 0.5 * StrictMath.log(2);

  /**
   * Compares.
   *
   * @return nothing where uniform sampling was not measured at such an error
   */
  public static Optional<Pace> of(Curve uniform, TargetRuns target, Cost cost) {
    double samples = samples(uniform, Errors.together(target.errors()).levels(), null);
    if (Double.isNaN(samples)) {
      return Optional.empty();
    }
    double perSample = last(uniform).cost(cost) / last(uniform).samples();
    double unit = perSample / target.cost(cost);
    int runs = Math.min(target.errors().size(), last(uniform).runs().size());
    Interval interval =
        Interval.bootstrap(
            runs, drawn -> unit * samples(uniform, draw(target.errors(), drawn), drawn));
    double affordable = target.cost(cost) / perSample;
    boolean measured = samples <= last(uniform).samples();
    return Optional.of(
        new Pace(samples, measured, unit * samples, interval, error(uniform, affordable)));
  }

  private static Measurement last(Curve curve) {
    return curve.points().get(curve.points().size() - 1);
  }

  /** Returns how many samples reach an error, by a power law between points; NaN if none does. */
  private static double samples(Curve curve, double levels, int[] drawn) {
    double before = Double.NaN;
    double error = Double.NaN;
    Measurement last = null;
    for (Measurement point : curve.points()) {
      before = error;
      error = drawn == null ? point.error().levels() : draw(point.runs(), drawn);
      last = point;
      if (error <= levels) {
        break;
      }
    }
    if (last.samples() == 1 || !(error > 0)) {
      return error <= levels ? last.samples() : Double.NaN;
    }
    double fall = StrictMath.log(before / error);
    double doublings = StrictMath.log(before / levels) / Math.max(fall, LEAST_FALL);
    return last.samples() / 2.0 * StrictMath.pow(2, doublings);
  }

  /** Returns the error with some samples, between points and beyond them by a power law. */
  private static double error(Curve curve, double samples) {
    List<Measurement> points = curve.points();
    if (points.size() == 1 || samples <= 1) {
      return points.get(0).error().levels();
    }
    int next = 1;
    while (next + 1 < points.size() && points.get(next).samples() < samples) {
      next++;
    }
    double one = Math.max(points.get(next - 1).error().levels(), Curve.NONE);
    double two = Math.max(points.get(next).error().levels(), Curve.NONE);
    double doublings = StrictMath.log(samples / points.get(next - 1).samples()) / StrictMath.log(2);
    return one * StrictMath.pow(two / one, doublings);
  }

  private static double draw(List<Errors> runs, int[] drawn) {
    List<Errors> chosen = new ArrayList<>();
    for (int run : drawn) {
      chosen.add(runs.get(run));
    }
    return Errors.together(chosen).levels();
  }
}
