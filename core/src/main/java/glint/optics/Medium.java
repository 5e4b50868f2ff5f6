package glint.optics;

import glint.color.Rgb;
import glint.math.Check;

/**
 * What fills the inside of a transparent surface; immutable.
 *
 * @param ior the index of refraction, 1 for vacuum
 * @param absorption the coefficient of Beer and Lambert's law per unit length, channel by channel
 * @param priority where media overlap, the one of the highest priority is there (Schmidt and Budge,
 *     Simple Nested Dielectrics in Ray Traced Images, 2002)
 */
public record Medium(double ior, Rgb absorption, int priority) {

  /** Nothing: what is outside of everything. */
  public static final Medium VACUUM = new Medium(1, Rgb.BLACK, Integer.MIN_VALUE);

  /** Returns whether light fades on its way. */
  public boolean absorbs() {
    return !absorption.isBlack();
  }

  /**
   * Returns the share of light left after a length, exp(-σ·length); what does not fade does not
   * fade over an infinite length either.
   *
   * @param sigma the coefficient of one channel
   */
  public double transmission(double sigma, double length) {
    return sigma == 0 ? 1 : StrictMath.exp(-sigma * length);
  }

  /** Returns whether this is no medium at all: nothing bends, absorbs or displaces others in it. */
  public boolean isVacuum() {
    return ior == 1 && absorption.isBlack() && priority <= 0;
  }

  /** Checks that the index is positive and the absorption finite and not negative. */
  public Medium {
    Check.range("ior", ior, 0.01, 100);
    absorption.requireLight("absorption");
  }
}
