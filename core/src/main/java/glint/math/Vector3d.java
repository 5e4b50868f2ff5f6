package glint.math;

/**
 * A point or direction in three-dimensional space; immutable.
 *
 * <p>Right-handed world, lengths in scene units. All arithmetic is plain IEEE double: {@code + - *
 * /} and {@code sqrt} only, so every platform gives the same bits.
 */
public record Vector3d(double x, double y, double z) {

  /** The origin. */
  public static final Vector3d ZERO = new Vector3d(0, 0, 0);

  /** Returns {@code this + v}. */
  public Vector3d plus(Vector3d v) {
    return new Vector3d(x + v.x, y + v.y, z + v.z);
  }

  /** Returns {@code this - v}. */
  public Vector3d minus(Vector3d v) {
    return new Vector3d(x - v.x, y - v.y, z - v.z);
  }

  /** Returns this vector times {@code s}. */
  public Vector3d times(double s) {
    return new Vector3d(x * s, y * s, z * s);
  }

  /** Returns {@code -this}. */
  public Vector3d negated() {
    return new Vector3d(-x, -y, -z);
  }

  /** Returns the dot product of this vector and {@code v}. */
  public double dot(Vector3d v) {
    return x * v.x + y * v.y + z * v.z;
  }

  /** Returns the cross product {@code this × v}. */
  public Vector3d cross(Vector3d v) {
    return new Vector3d(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x);
  }

  /** Returns the Euclidean length; squares may overflow or underflow beyond 1e±150. */
  public double length() {
    return Math.sqrt(dot(this));
  }

  /** Returns the largest absolute component. */
  public double maxAbs() {
    return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
  }

  /**
   * Returns the unit vector of this direction.
   *
   * <p>Scales by a power of two first, so that neither huge nor tiny vectors overflow or vanish,
   * and so that {@code v} and {@code v * 2^k} have bit-identical unit vectors.
   *
   * @throws ArithmeticException if the vector is zero or not finite
   */
  public Vector3d normalized() {
    double largest = maxAbs();
    if (!(largest > 0 && largest < Double.POSITIVE_INFINITY)) {
      throw new ArithmeticException("a direction must be finite and not zero, but is " + this);
    }
    int exponent = Math.getExponent(largest);
    Vector3d scaled =
        new Vector3d(Math.scalb(x, -exponent), Math.scalb(y, -exponent), Math.scalb(z, -exponent));
    double length = scaled.length();
    return new Vector3d(scaled.x / length, scaled.y / length, scaled.z / length);
  }

  /** Returns whether all three components are finite numbers. */
  public boolean isFinite() {
    return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
  }

  /** Returns {@code "(x, y, z)"}. */
  @Override
  public String toString() {
    return "(" + x + ", " + y + ", " + z + ")";
  }
}
