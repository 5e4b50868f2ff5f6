package glint.bench;

import glint.report.Honesty;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What the images of several scenes come to. */
final class Score {

  /** Uniform samples from which a render to an error should be no slower. */
  private static final int ENOUGH = 4;

  final List<Honesty.Claim> claims = new ArrayList<>();
  private final List<Double> fewer = new ArrayList<>();
  private final List<Double> faster = new ArrayList<>();
  private double leastFewer = Double.POSITIVE_INFINITY;
  private double leastFaster = Double.POSITIVE_INFINITY;

  /** Adds the images of one scene, and how many times fewer rays and seconds they took. */
  void add(List<Honesty.Claim> more, UniformErrors.Need need, double fewerRays, double lessTime) {
    claims.addAll(more);
    fewer.add(fewerRays);
    faster.add(lessTime);
    if (need.samples() >= ENOUGH) {
      leastFewer = Math.min(leastFewer, fewerRays);
      leastFaster = Math.min(leastFaster, lessTime);
    }
  }

  /** Adds what others have. */
  void add(Score other) {
    claims.addAll(other.claims);
    fewer.addAll(other.fewer);
    faster.addAll(other.faster);
    leastFewer = Math.min(leastFewer, other.leastFewer);
    leastFaster = Math.min(leastFaster, other.leastFaster);
  }

  /** Prints a row: means are geometric, the least over scenes where uniform needs 4 samples. */
  void print(String name) {
    Honesty honesty = Honesty.of(claims);
    System.out.printf(
        Locale.ROOT,
        "| %s | %d | %.1f %% | %.3f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |%n",
        name,
        honesty.runs(),
        100 * honesty.kept(),
        honesty.ratio().median(),
        honesty.ratio().min(),
        honesty.ratio().max(),
        geometricMean(fewer),
        leastFewer,
        geometricMean(faster),
        leastFaster);
  }

  private static double geometricMean(List<Double> values) {
    double sum = 0;
    for (double value : values) {
      sum += Math.log(value);
    }
    return Math.exp(sum / values.size());
  }
}
