package glint.report;

import java.util.List;

/**
 * What some number of samples costs and how far the images are from the truth.
 *
 * @param samples samples of every pixel
 * @param runs the errors of every run; each run has another randomisation
 * @param seconds wall time of tracing alone, over the runs
 * @param rays rays of one run
 * @param trusted whether the truth is known ten times better than the error claims
 */
public record Measurement(
    int samples, List<Errors> runs, Spread seconds, Rays rays, boolean trusted) {

  /** What an error is drawn against. */
  public enum Cost {
    /** Wall seconds of tracing, the median of the runs. */
    SECONDS,
    /** Rays of all kinds. */
    RAYS
  }

  /** Returns the errors of all runs together. */
  public Errors error() {
    return Errors.together(runs);
  }

  /** Returns what an image costs. */
  public double cost(Cost unit) {
    return unit == Cost.RAYS ? rays.total() : seconds.median();
  }
}
