package glint.optics;

import glint.math.Check;

/**
 * How often an image lies in the square of u and v, 0 to 1, and what lies around it; immutable.
 *
 * @param scaleU what u is multiplied by
 * @param offsetU what is added then
 */
public record Layout(double scaleU, double scaleV, double offsetU, double offsetV, Wrap wrap) {

  /** Once, and again on all sides. */
  public static final Layout ONCE = new Layout(1, 1, 0, 0, Wrap.REPEAT);

  /** The largest number: pixels of an image can still be told apart. */
  private static final double LARGEST = 1e6;

  /** Checks the numbers. */
  public Layout {
    Check.range("scale", scaleU, -LARGEST, LARGEST);
    Check.range("scale", scaleV, -LARGEST, LARGEST);
    Check.range("offset", offsetU, -LARGEST, LARGEST);
    Check.range("offset", offsetV, -LARGEST, LARGEST);
  }

  /**
   * Returns where on the image a u lies, repetitions counted on; 0 if that is beyond all bounds.
   */
  double placeU(double u) {
    return bounded(scaleU * u + offsetU);
  }

  /** Returns the same for a v. */
  double placeV(double v) {
    return bounded(scaleV * v + offsetV);
  }

  private double bounded(double place) {
    double finite = Math.abs(place) < Double.POSITIVE_INFINITY ? place : 0;
    return wrap == Wrap.CLAMP ? wrap.within(finite) : finite;
  }
}
