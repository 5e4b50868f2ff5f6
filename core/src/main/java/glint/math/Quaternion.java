package glint.math;

/**
 * A rotation in space as a unit quaternion {@code w + xi + yj + zk}; immutable.
 *
 * <p>The constructor normalises, so that long products do not drift. {@code q} and {@code -q} are
 * the same rotation.
 */
public record Quaternion(double w, double x, double y, double z) {

  /**
   * Normalises the four numbers to a length of 1 within 2u, scaling by a power of two first so that
   * lengths from 1e-300 to 1e300 neither overflow nor vanish.
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
    double length = length(w, x, y, z);
    w /= length;
    x /= length;
    y /= length;
    z /= length;
    // One Newton step, with exact squares, leaves little but the rounding of the four numbers.
    double missing = 1 - w * w - x * x - y * y - z * z;
    missing -=
        Rounding.ofSquare(w) + Rounding.ofSquare(x) + Rounding.ofSquare(y) + Rounding.ofSquare(z);
    w += w * missing / 2;
    x += x * missing / 2;
    y += y * missing / 2;
    z += z * missing / 2;
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

  /**
   * Returns the turns by {@code x}, {@code y} and {@code z} degrees about the x, the y and the z
   * axis, in this order; the axes stand still.
   */
  public static Quaternion euler(double x, double y, double z) {
    return aboutAxis(new Vector3d(1, 0, 0), x)
        .then(aboutAxis(new Vector3d(0, 1, 0), y))
        .then(aboutAxis(new Vector3d(0, 0, 1), z));
  }

  /**
   * Returns the rotation that turns the z axis to {@code forward}, and the y axis as near to {@code
   * up} as it can be.
   *
   * @throws ArithmeticException if a direction is zero or not finite, or both are parallel
   */
  public static Quaternion looking(Vector3d forward, Vector3d up) {
    Vector3d z = forward.normalized();
    Vector3d across = up.normalized().cross(z);
    // Two parallel unit vectors, each rounded, have a cross product of a few roundings.
    if (across.maxAbs() <= Rounding.gamma(8)) {
      throw new ArithmeticException("look and up must not be parallel");
    }
    // Next to parallel the cross product is not quite square to z: twice is enough.
    across = across.normalized();
    Vector3d x = across.minus(z.times(across.dot(z))).normalized();
    return ofAxes(x, z.cross(x), z);
  }

  /**
   * Returns the rotation that turns the axes to three directions, the columns of its matrix, which
   * are of length 1 and square to each other, and turn as a right hand's fingers do.
   *
   * <p>Divides by the largest of the four numbers (Shepperd 1978, Quaternion from Rotation Matrix):
   * precise at every angle.
   */
  public static Quaternion ofAxes(Vector3d x, Vector3d y, Vector3d z) {
    double trace = x.x() + y.y() + z.z();
    double largest = Math.max(Math.max(trace, x.x()), Math.max(y.y(), z.z()));
    double four = 1 + 2 * largest - trace;
    if (largest == trace) {
      return new Quaternion(1 + trace, y.z() - z.y(), z.x() - x.z(), x.y() - y.x());
    } else if (largest == x.x()) {
      return new Quaternion(y.z() - z.y(), four, x.y() + y.x(), z.x() + x.z());
    } else if (largest == y.y()) {
      return new Quaternion(z.x() - x.z(), x.y() + y.x(), four, y.z() + z.y());
    } else {
      return new Quaternion(x.y() - y.x(), z.x() + x.z(), y.z() + z.y(), four);
    }
  }

  /** Returns the rotation that does this one first and {@code next} after it. */
  public Quaternion then(Quaternion next) {
    return new Quaternion(
        next.w * w - next.x * x - next.y * y - next.z * z,
        next.w * x + next.x * w + next.y * z - next.z * y,
        next.w * y - next.x * z + next.y * w + next.z * x,
        next.w * z + next.x * y - next.y * x + next.z * w);
  }

  /**
   * Returns the rotation at a share {@code t}, 0 to 1, of the shorter way from this one to another,
   * at even speed (Shoemake 1985, Animating Rotation with Quaternion Curves).
   *
   * <p>The angle comes from chord and sum, not from the cosine, which knows nothing of small ones.
   */
  public Quaternion slerp(Quaternion to, double t) {
    double side = w * to.w + x * to.x + y * to.y + z * to.z < 0 ? -1 : 1;
    double chord = length(w - side * to.w, x - side * to.x, y - side * to.y, z - side * to.z);
    double sum = length(w + side * to.w, x + side * to.x, y + side * to.y, z + side * to.z);
    if (chord == 0) {
      return this;
    }
    double angle = 2 * StrictMath.atan2(chord, sum);
    double sine = StrictMath.sin(angle);
    double a = StrictMath.sin((1 - t) * angle) / sine;
    double b = side * StrictMath.sin(t * angle) / sine;
    return new Quaternion(a * w + b * to.w, a * x + b * to.x, a * y + b * to.y, a * z + b * to.z);
  }

  private static double length(double w, double x, double y, double z) {
    return Math.sqrt(w * w + x * x + y * y + z * z);
  }
}
