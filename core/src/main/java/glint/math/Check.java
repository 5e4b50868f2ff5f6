package glint.math;

/** Checks of the numbers that people write; each names the field in its error. */
public final class Check {

  /** The largest coordinate or length: products of three such numbers do not overflow. */
  public static final double LARGEST = 1e100;

  /** The smallest length: squares of products of it do not vanish. */
  public static final double SMALLEST = 1e-100;

  private Check() {}

  /**
   * Checks a point or vector.
   *
   * @throws BadValueException unless all components are finite and at most {@link #LARGEST}
   */
  public static void finite(String field, Vector3d v) {
    if (!(v.maxAbs() <= LARGEST)) {
      throw new BadValueException(field, "must be finite numbers up to 1e100, but is " + v);
    }
  }

  /**
   * Checks a direction.
   *
   * @throws BadValueException unless it is finite and not zero
   */
  public static void direction(String field, Vector3d v) {
    finite(field, v);
    if (v.maxAbs() == 0) {
      throw new BadValueException(field, "must not be zero");
    }
  }

  /**
   * Checks a length.
   *
   * @throws BadValueException unless it is {@link #SMALLEST} to {@link #LARGEST}
   */
  public static void positive(String field, double v) {
    if (!(v > 0 && v <= LARGEST)) {
      throw new BadValueException(field, "must be a positive number up to 1e100, but is " + v);
    }
    if (v < SMALLEST) {
      throw new BadValueException(field, "must be at least 1e-100, but is " + v);
    }
  }

  /**
   * Checks a number against a closed range.
   *
   * @throws BadValueException unless {@code least <= v <= greatest}
   */
  public static void range(String field, double v, double least, double greatest) {
    if (!(v >= least && v <= greatest)) {
      throw new BadValueException(
          field, "must lie in " + least + " to " + greatest + ", but is " + v);
    }
  }
}
