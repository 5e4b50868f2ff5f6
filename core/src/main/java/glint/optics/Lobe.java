package glint.optics;

/** The shape of a highlight: a power of a cosine. */
public final class Lobe {

  /** Whole exponents up to this are multiplied out. */
  private static final int MULTIPLIED = 1024;

  private Lobe() {}

  /**
   * Returns {@code cos} to the power of {@code shininess}.
   *
   * <p>A whole exponent n of usual size is multiplied out by squaring, to within a relative n·u
   * (every product adds one rounding, every squaring doubles what is there): several times faster
   * than StrictMath.pow, which makes garbage besides. 0 to the power of 0 is 1.
   *
   * @param cos 0 to 1
   * @param shininess at least 0
   */
  public static double of(double cos, double shininess) {
    int n = (int) shininess;
    if (n != shininess || n > MULTIPLIED) {
      return StrictMath.pow(cos, shininess);
    }
    double power = 1;
    for (double square = cos; n != 0; n >>= 1, square *= square) {
      if ((n & 1) != 0) {
        power *= square;
      }
    }
    return power;
  }
}
