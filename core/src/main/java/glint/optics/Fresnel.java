package glint.optics;

/**
 * What a smooth boundary between two dielectrics does with light, exactly and unpolarised.
 *
 * <p>Source: Born and Wolf, Principles of Optics, 7th ed., section 1.5. {@code eta} is the index of
 * refraction on the side of the incoming ray over that on the other side; cosines are those of the
 * angles to the normal, 0 to 1.
 */
public final class Fresnel {

  private Fresnel() {}

  /**
   * Returns the cosine of the refracted ray, by Snell's law, or -1 where all light is reflected.
   *
   * <p>1 - cos² is taken as (1 - cos)(1 + cos), which keeps its digits at normal incidence.
   */
  public static double cosOut(double cosIn, double eta) {
    return cosine(eta * eta * ((1 - cosIn) * (1 + cosIn)));
  }

  /** Returns the cosine of the refracted ray, given the square of its sine, or -1. */
  public static double cosine(double sinOut2) {
    return sinOut2 < 1 ? Math.sqrt(1 - sinOut2) : -1;
  }

  /**
   * Returns the share of the light that is reflected, 0 to 1; none between equal indices.
   *
   * @param cosOut what {@link #cosOut} gave for the same arguments; if negative, all is reflected
   */
  public static double reflectance(double cosIn, double cosOut, double eta) {
    if (cosOut < 0) {
      return 1;
    }
    if (eta == 1) {
      return 0;
    }
    // The amplitudes that are reflected, for light polarised across and along the plane of
    // incidence.
    double s = (eta * cosIn - cosOut) / (eta * cosIn + cosOut);
    double p = (cosIn - eta * cosOut) / (cosIn + eta * cosOut);
    return (s * s + p * p) / 2;
  }

  /**
   * Returns the share of the light that passes, from its own amplitudes: 1 - reflectance to within
   * rounding.
   *
   * @param cosOut as for {@link #reflectance}
   */
  public static double transmittance(double cosIn, double cosOut, double eta) {
    if (cosOut < 0) {
      return 0;
    }
    double s = 2 * eta * cosIn / (eta * cosIn + cosOut);
    double p = 2 * eta * cosIn / (cosIn + eta * cosOut);
    return cosIn == 0 ? 0 : cosOut / (eta * cosIn) * (s * s + p * p) / 2;
  }
}
