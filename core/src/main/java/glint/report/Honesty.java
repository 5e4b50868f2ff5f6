package glint.report;

import java.util.List;

/**
 * Whether images keep what they claim.
 *
 * @param runs how many images were asked for
 * @param kept the share of them whose true error is at or below its target
 * @param ratio true over claimed errors, over the claims that are large enough to tell; empty
 *     figures (NaN) if none is
 */
public record Honesty(int runs, double kept, Spread ratio) {

  /** Claims below this many display levels are left out of the ratio. */
  private static final double TELLING = 0.05;

  /**
   * One image.
   *
   * @param target the error that was asked for, in display levels
   * @param claimed the error that the image claims
   * @param actual its true error
   */
  public record Claim(double target, double claimed, double actual) {}

  /** Judges at least one image. */
  public static Honesty of(List<Claim> claims) {
    long kept = claims.stream().filter(claim -> claim.actual <= claim.target).count();
    double[] ratios =
        claims.stream()
            .filter(claim -> claim.claimed >= TELLING)
            .mapToDouble(claim -> claim.actual / claim.claimed)
            .toArray();
    Spread ratio =
        ratios.length == 0 ? new Spread(Double.NaN, Double.NaN, Double.NaN) : Spread.of(ratios);
    return new Honesty(claims.size(), (double) kept / claims.size(), ratio);
  }
}
