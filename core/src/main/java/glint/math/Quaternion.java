package glint.math;

/**
 * A rotation in space as a unit quaternion {@code w + xi + yj + zk}; immutable.
 *
 * <p>The constructor normalises, so that long products do not drift. {@code q} and {@code -q} are
 * the same rotation.
 */
public record Quaternion(double w, double x, double y, double z) {

  /**
   * Normalises the four numbers, scaling by a power of two first so that lengths from 1e-300 to
   * 1e300 neither overflow nor vanish.
   *
   * @throws ArithmeticException if all are zero or one is not finite
   */
  public Quaternion {
    double largest =
        Math.max(Math.max(Math.abs(w), Math.abs(x)), Math.max(Math.abs(y), Math.abs(z)));
    boolean finite =
        Double.isFinite(w) && Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    if (!(largest > 0 && finite)) {
      throw new ArithmeticException(
          "a quaternion must be finite and not zero, but is ["
              + w
              + ", "
              + x
              + ", "
              + y
              + ", "
              + z
              + "]");
    }
    int exponent = Math.getExponent(largest);
    w = Math.scalb(w, -exponent);
    x = Math.scalb(x, -exponent);
    y = Math.scalb(y, -exponent);
    z = Math.scalb(z, -exponent);
    double length = Math.sqrt(w * w + x * x + y * y + z * z);
    w /= length;
    x /= length;
    y /= length;
    z /= length;
  }

  /**
   * Returns the rotation about {@code axis} by {@code degrees}, counter-clockwise when the axis
   * points at the viewer.
   *
   * @throws ArithmeticException if the axis is zero or not finite
   */
  public static Quaternion aboutAxis(Vector3d axis, double degrees) {
    Vector3d unit = axis.normalized();
    double half = StrictMath.toRadians(degrees) / 2;
    double s = StrictMath.sin(half);
    return new Quaternion(StrictMath.cos(half), s * unit.x(), s * unit.y(), s * unit.z());
  }
}
