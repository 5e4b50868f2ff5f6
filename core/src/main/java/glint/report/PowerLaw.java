package glint.report;

/**
 * A curve y = factor · x^slope: a straight line where both axes are logarithmic.
 *
 * <p>NaN where points do not determine it.
 */
public record PowerLaw(double factor, double slope) {

  /** Fits the line of least squares through the logarithms of positive values. */
  public static PowerLaw fit(double[] x, double[] y) {
    int n = x.length;
    double meanX = 0;
    double meanY = 0;
    for (int i = 0; i < n; i++) {
      meanX += StrictMath.log(x[i]) / n;
      meanY += StrictMath.log(y[i]) / n;
    }
    double xx = 0;
    double xy = 0;
    for (int i = 0; i < n; i++) {
      double dx = StrictMath.log(x[i]) - meanX;
      xx += dx * dx;
      xy += dx * (StrictMath.log(y[i]) - meanY);
    }
    double slope = xy / xx;
    return new PowerLaw(StrictMath.exp(meanY - slope * meanX), slope);
  }

  /** Returns y at x. */
  public double at(double x) {
    return factor * StrictMath.pow(x, slope);
  }

  /** Returns x where the curve has a height y. */
  public double inverse(double y) {
    return StrictMath.pow(y / factor, 1 / slope);
  }
}
