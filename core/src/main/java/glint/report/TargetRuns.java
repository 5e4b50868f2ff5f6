package glint.report;

import java.util.List;

/**
 * Images that were asked for with one error, each with another seed.
 *
 * @param target the error asked for, in display levels
 * @param claims what each claims, and what is true
 * @param errors the errors of every run
 * @param seconds wall time of tracing alone, over the runs
 * @param rays rays of one run
 * @param samples camera rays of a pixel, on average
 * @param truncation the largest bound on the error by bounces not followed, in display levels
 */
public record TargetRuns(
    double target,
    List<Honesty.Claim> claims,
    List<Errors> errors,
    Spread seconds,
    Rays rays,
    double samples,
    double truncation) {

  /** Returns the errors of all runs together. */
  public Errors error() {
    return Errors.together(errors);
  }

  /** Returns what an image costs. */
  public double cost(Measurement.Cost unit) {
    return unit == Measurement.Cost.RAYS ? rays.total() : seconds.median();
  }
}
