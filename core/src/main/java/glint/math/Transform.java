package glint.math;

/**
 * An affine map of space with its inverse; immutable.
 *
 * <p>Holds both as rows of a 3×4 matrix: {@code p' = M p + translation}.
 */
public final class Transform {

  /** The map that leaves everything where it is. */
  public static final Transform IDENTITY =
      new Transform(
          new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
          new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});

  private final double[] forward;
  private final double[] inverse;

  private Transform(double[] forward, double[] inverse) {
    this.forward = forward;
    this.inverse = inverse;
  }

  /** Returns the move by {@code offset}. */
  public static Transform translate(Vector3d offset) {
    return diagonal(1, 1, 1, offset);
  }

  /**
   * Returns the scaling about the origin by one factor an axis; negative factors mirror.
   *
   * @throws ArithmeticException if a factor is zero or not finite, or its inverse is not
   */
  public static Transform scale(Vector3d factors) {
    requireInvertible(factors.x());
    requireInvertible(factors.y());
    requireInvertible(factors.z());
    return diagonal(factors.x(), factors.y(), factors.z(), Vector3d.ZERO);
  }

  /** Returns the rotation about the origin by a quaternion (Shoemake 1985). */
  public static Transform rotate(Quaternion q) {
    double w = q.w();
    double x = q.x();
    double y = q.y();
    double z = q.z();
    double[] m = {
      1 - 2 * (y * y + z * z),
      2 * (x * y - w * z),
      2 * (x * z + w * y),
      0,
      2 * (x * y + w * z),
      1 - 2 * (x * x + z * z),
      2 * (y * z - w * x),
      0,
      2 * (x * z - w * y),
      2 * (y * z + w * x),
      1 - 2 * (x * x + y * y),
      0
    };
    double[] transposed = {
      m[0], m[4], m[8], 0,
      m[1], m[5], m[9], 0,
      m[2], m[6], m[10], 0
    };
    return new Transform(m, transposed);
  }

  /**
   * Returns the map with the given rows of a 3×4 matrix.
   *
   * @param rows twelve numbers, row by row, the translation in every fourth place
   * @throws ArithmeticException if the 3×3 part is singular or a number is not finite
   */
  public static Transform matrix(double... rows) {
    if (rows.length != 12) {
      throw new IllegalArgumentException("a matrix has 12 numbers, not " + rows.length);
    }
    double[] m = rows.clone();
    double[] inverse = new double[12];
    // Divide the matrix by a power of two before the cofactors, so that no product overflows.
    double largest = 0;
    for (int i = 0; i < 12; i++) {
      if (!Double.isFinite(m[i])) {
        throw new ArithmeticException("a matrix must hold finite numbers, but has " + m[i]);
      }
      largest = i % 4 == 3 ? largest : Math.max(largest, Math.abs(m[i]));
    }
    int exponent = largest > 0 ? Math.getExponent(largest) : 0;
    double[] s = new double[12];
    for (int i = 0; i < 12; i++) {
      s[i] = Math.scalb(m[i], -exponent);
    }
    double det = 0;
    for (int column = 0; column < 3; column++) {
      det += s[column] * cofactor(s, 0, column);
    }
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        inverse[4 * row + column] = Math.scalb(cofactor(s, column, row) / det, -exponent);
      }
    }
    for (int row = 0; row < 3; row++) {
      inverse[4 * row + 3] = -dotRow(inverse, row, m[3], m[7], m[11]);
    }
    for (double v : inverse) {
      if (!Double.isFinite(v)) {
        throw new ArithmeticException("the matrix is singular: it flattens space");
      }
    }
    return new Transform(m, inverse);
  }

  /**
   * Returns the map that applies this one first and {@code next} after it.
   *
   * @throws ArithmeticException if its numbers, or those of its inverse, are not finite
   */
  public Transform then(Transform next) {
    double[] m = product(next.forward, forward);
    double[] back = product(inverse, next.inverse);
    for (int i = 0; i < 12; i++) {
      if (!(Double.isFinite(m[i]) && Double.isFinite(back[i]))) {
        throw new ArithmeticException("the transforms up to here leave the range of numbers");
      }
    }
    return new Transform(m, back);
  }

  /** Returns the inverse map. */
  public Transform inverted() {
    return new Transform(inverse, forward);
  }

  /** Returns the image of a point. */
  public Vector3d point(Vector3d p) {
    return new Vector3d(
        dotRow(forward, 0, p.x(), p.y(), p.z()) + forward[3],
        dotRow(forward, 1, p.x(), p.y(), p.z()) + forward[7],
        dotRow(forward, 2, p.x(), p.y(), p.z()) + forward[11]);
  }

  /** Returns the image of a direction: the translation does not apply. */
  public Vector3d direction(Vector3d d) {
    return new Vector3d(
        dotRow(forward, 0, d.x(), d.y(), d.z()),
        dotRow(forward, 1, d.x(), d.y(), d.z()),
        dotRow(forward, 2, d.x(), d.y(), d.z()));
  }

  /** Returns the image of a surface normal, by the inverse transpose; not of unit length. */
  public Vector3d normal(Vector3d n) {
    return new Vector3d(
        inverse[0] * n.x() + inverse[4] * n.y() + inverse[8] * n.z(),
        inverse[1] * n.x() + inverse[5] * n.y() + inverse[9] * n.z(),
        inverse[2] * n.x() + inverse[6] * n.y() + inverse[10] * n.z());
  }

  /** Returns a copy of the twelve numbers of the forward matrix, row by row. */
  public double[] rows() {
    return forward.clone();
  }

  /** Returns whether this is exactly the identity. */
  public boolean isIdentity() {
    return java.util.Arrays.equals(forward, IDENTITY.forward);
  }

  /**
   * Returns the factor by which this map scales all lengths, or 0 if it scales directions
   * differently: whether a sphere stays a sphere to within the rounding of the matrix.
   */
  public double uniformScale() {
    // Divide by a power of two first, so that no square overflows or vanishes.
    int exponent = Math.getExponent(largest());
    Vector3d[] columns = new Vector3d[3];
    for (int i = 0; i < 3; i++) {
      columns[i] = column(i).times(Math.scalb(1.0, -exponent));
    }
    double first = columns[0].length();
    double bound = 16 * Rounding.U;
    for (int i = 0; i < 3; i++) {
      if (!(Math.abs(columns[i].length() - first) <= bound * first)) {
        return 0;
      }
      // Columns at right angles: their dot product is rounding only.
      if (!(Math.abs(columns[i].dot(columns[(i + 1) % 3])) <= bound * first * first)) {
        return 0;
      }
    }
    return Math.scalb(first, exponent);
  }

  /**
   * Returns the largest absolute number of the 3x3 part: no length grows by more than thrice it.
   */
  public double largest() {
    return Math.max(column(0).maxAbs(), Math.max(column(1).maxAbs(), column(2).maxAbs()));
  }

  /** Returns whether this map turns a right hand into a left one. */
  public boolean mirrors() {
    Vector3d x = column(0).normalized();
    return x.cross(column(1).normalized()).dot(column(2).normalized()) < 0;
  }

  /**
   * Returns by how much a round trip through this map and its inverse may magnify rounding,
   * component by component: the largest row sum of |M||M⁻¹|, at least 1.
   */
  public double conditioning() {
    double largest = 1;
    for (int row = 0; row < 3; row++) {
      double sum = 0;
      for (int i = 0; i < 3; i++) {
        for (int column = 0; column < 3; column++) {
          sum += Math.abs(forward[4 * row + i] * inverse[4 * i + column]);
        }
      }
      largest = Math.max(largest, sum);
    }
    return largest;
  }

  /**
   * Returns by how much a round trip may magnify rounding where object space mixes the components:
   * the product of the Frobenius norms of M and M⁻¹, at least the ratio of its greatest to its
   * least stretch.
   */
  public double flattening() {
    return norm(forward) * norm(inverse);
  }

  private static double norm(double[] m) {
    double largest = 0;
    for (int i = 0; i < 12; i++) {
      largest = i % 4 == 3 ? largest : Math.max(largest, Math.abs(m[i]));
    }
    double sum = 0;
    for (int i = 0; i < 12; i++) {
      sum += i % 4 == 3 ? 0 : (m[i] / largest) * (m[i] / largest);
    }
    return largest * Math.sqrt(sum);
  }

  private Vector3d column(int i) {
    return new Vector3d(forward[i], forward[4 + i], forward[8 + i]);
  }

  private static Transform diagonal(double x, double y, double z, Vector3d t) {
    return new Transform(
        new double[] {x, 0, 0, t.x(), 0, y, 0, t.y(), 0, 0, z, t.z()},
        new double[] {1 / x, 0, 0, -t.x() / x, 0, 1 / y, 0, -t.y() / y, 0, 0, 1 / z, -t.z() / z});
  }

  private static void requireInvertible(double factor) {
    if (!(Double.isFinite(factor) && factor != 0 && Double.isFinite(1 / factor))) {
      throw new ArithmeticException("a scale factor must be finite and not zero, but is " + factor);
    }
  }

  private static double[] product(double[] a, double[] b) {
    double[] c = new double[12];
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 4; column++) {
        c[4 * row + column] = dotRow(a, row, b[column], b[4 + column], b[8 + column]);
      }
      c[4 * row + 3] += a[4 * row + 3];
    }
    return c;
  }

  private static double dotRow(double[] m, int row, double x, double y, double z) {
    return m[4 * row] * x + m[4 * row + 1] * y + m[4 * row + 2] * z;
  }

  /** The signed 2×2 minor of an element, indices taken cyclically. */
  private static double cofactor(double[] m, int row, int column) {
    int r1 = 4 * ((row + 1) % 3);
    int r2 = 4 * ((row + 2) % 3);
    int c1 = (column + 1) % 3;
    int c2 = (column + 2) % 3;
    return m[r1 + c1] * m[r2 + c2] - m[r1 + c2] * m[r2 + c1];
  }
}
