package glint.math;

import java.util.Arrays;

/**
 * An affine map of space with its inverse; immutable.
 *
 * <p>{@code p' = M p + T}; holds the 3×3 matrices M and M⁻¹ and the image T of the origin. The way
 * back is {@code M⁻¹ (p' - T)}: near T, wherever that is, it loses nothing.
 */
public final class Transform {

  /** How many numbers {@link #copyTo} writes. */
  public static final int NUMBERS = 21;

  /** The map that leaves everything where it is. */
  public static final Transform IDENTITY = translate(Vector3d.ZERO);

  // The rows of M. Fields, because scenes hold many transforms, and arrays would double their size.
  private final double xx;
  private final double xy;
  private final double xz;
  private final double yx;
  private final double yy;
  private final double yz;
  private final double zx;
  private final double zy;
  private final double zz;

  // The rows of M⁻¹.
  private final double backXx;
  private final double backXy;
  private final double backXz;
  private final double backYx;
  private final double backYy;
  private final double backYz;
  private final double backZx;
  private final double backZy;
  private final double backZz;

  private final double tx;
  private final double ty;
  private final double tz;

  /** Takes the nine numbers of M and of M⁻¹, row by row. */
  private Transform(double[] m, double[] back, double x, double y, double z) {
    xx = m[0];
    xy = m[1];
    xz = m[2];
    yx = m[3];
    yy = m[4];
    yz = m[5];
    zx = m[6];
    zy = m[7];
    zz = m[8];
    backXx = back[0];
    backXy = back[1];
    backXz = back[2];
    backYx = back[3];
    backYy = back[4];
    backYz = back[5];
    backZx = back[6];
    backZy = back[7];
    backZz = back[8];
    tx = x;
    ty = y;
    tz = z;
  }

  /** Returns the move by {@code offset}. */
  public static Transform translate(Vector3d offset) {
    return new Transform(diagonal(1, 1, 1), diagonal(1, 1, 1), offset.x(), offset.y(), offset.z());
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
    return new Transform(
        diagonal(factors.x(), factors.y(), factors.z()),
        diagonal(1 / factors.x(), 1 / factors.y(), 1 / factors.z()),
        0,
        0,
        0);
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
      2 * (x * y + w * z),
      1 - 2 * (x * x + z * z),
      2 * (y * z - w * x),
      2 * (x * z - w * y),
      2 * (y * z + w * x),
      1 - 2 * (x * x + y * y)
    };
    double[] transposed = {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
    return new Transform(m, transposed, 0, 0, 0);
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
    double[] m = new double[9];
    double largest = 0;
    for (int i = 0; i < 12; i++) {
      if (!Double.isFinite(rows[i])) {
        throw new ArithmeticException("a matrix must hold finite numbers, but has " + rows[i]);
      }
      if (i % 4 != 3) {
        m[i / 4 * 3 + i % 4] = rows[i];
        largest = Math.max(largest, Math.abs(rows[i]));
      }
    }
    return new Transform(m, inverse(m, largest), rows[3], rows[7], rows[11]);
  }

  private static double[] inverse(double[] m, double largest) {
    // Divide the matrix by a power of two before the cofactors, so that no product overflows.
    int exponent = largest > 0 ? Math.getExponent(largest) : 0;
    double[] s = new double[9];
    for (int i = 0; i < 9; i++) {
      s[i] = Math.scalb(m[i], -exponent);
    }
    double det = 0;
    for (int column = 0; column < 3; column++) {
      det += s[column] * cofactor(s, 0, column);
    }
    double[] inverse = new double[9];
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        double v = Math.scalb(cofactor(s, column, row) / det, -exponent);
        if (!Double.isFinite(v)) {
          throw new ArithmeticException("the matrix is singular: it flattens space");
        }
        inverse[3 * row + column] = v;
      }
    }
    return inverse;
  }

  /**
   * Returns the map that applies this one first and {@code next} after it.
   *
   * @throws ArithmeticException if its numbers, or those of its inverse, are not finite
   */
  public Transform then(Transform next) {
    Vector3d origin = next.point(new Vector3d(tx, ty, tz));
    Transform both =
        new Transform(
            product(next.linear(), linear()),
            product(back(), next.back()),
            origin.x(),
            origin.y(),
            origin.z());
    double[] numbers = new double[NUMBERS];
    both.copyTo(numbers);
    for (double v : numbers) {
      if (!Double.isFinite(v)) {
        throw new ArithmeticException("the transforms up to here leave the range of numbers");
      }
    }
    return both;
  }

  /** Returns the inverse map. */
  public Transform inverted() {
    double[] back = back();
    return new Transform(
        back,
        linear(),
        -dotRow(back, 0, tx, ty, tz),
        -dotRow(back, 1, tx, ty, tz),
        -dotRow(back, 2, tx, ty, tz));
  }

  /** Returns the image of a point. */
  public Vector3d point(Vector3d p) {
    Vector3d moved = direction(p);
    return new Vector3d(moved.x() + tx, moved.y() + ty, moved.z() + tz);
  }

  /** Returns the image of a direction: the translation does not apply. */
  public Vector3d direction(Vector3d d) {
    return new Vector3d(
        xx * d.x() + xy * d.y() + xz * d.z(),
        yx * d.x() + yy * d.y() + yz * d.z(),
        zx * d.x() + zy * d.y() + zz * d.z());
  }

  /** Returns the image of a surface normal, by the inverse transpose; not of unit length. */
  public Vector3d normal(Vector3d n) {
    return new Vector3d(
        backXx * n.x() + backYx * n.y() + backZx * n.z(),
        backXy * n.x() + backYy * n.y() + backZy * n.z(),
        backXz * n.x() + backYz * n.y() + backZz * n.z());
  }

  /** Returns the twelve numbers of the 3×4 matrix, row by row, T in every fourth place. */
  public double[] rows() {
    return new double[] {xx, xy, xz, tx, yx, yy, yz, ty, zx, zy, zz, tz};
  }

  /** Writes the rows of M⁻¹, those of M, and T to an array; makes nothing. */
  public void copyTo(double[] numbers) {
    numbers[0] = backXx;
    numbers[1] = backXy;
    numbers[2] = backXz;
    numbers[3] = backYx;
    numbers[4] = backYy;
    numbers[5] = backYz;
    numbers[6] = backZx;
    numbers[7] = backZy;
    numbers[8] = backZz;
    numbers[9] = xx;
    numbers[10] = xy;
    numbers[11] = xz;
    numbers[12] = yx;
    numbers[13] = yy;
    numbers[14] = yz;
    numbers[15] = zx;
    numbers[16] = zy;
    numbers[17] = zz;
    numbers[18] = tx;
    numbers[19] = ty;
    numbers[20] = tz;
  }

  /** Returns whether this is exactly the identity. */
  public boolean isIdentity() {
    return Arrays.equals(rows(), IDENTITY.rows());
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

  /** Returns the largest absolute number of M: no length grows by more than thrice it. */
  public double largest() {
    return largest(linear());
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
    double[] m = linear();
    double[] back = back();
    double largest = 1;
    for (int row = 0; row < 3; row++) {
      double sum = 0;
      for (int i = 0; i < 3; i++) {
        for (int column = 0; column < 3; column++) {
          sum += Math.abs(m[3 * row + i] * back[3 * i + column]);
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
    return norm(linear()) * norm(back());
  }

  private static double norm(double[] m) {
    double largest = largest(m);
    double sum = 0;
    for (double v : m) {
      sum += (v / largest) * (v / largest);
    }
    return largest * Math.sqrt(sum);
  }

  private static double largest(double[] m) {
    double largest = 0;
    for (double v : m) {
      largest = Math.max(largest, Math.abs(v));
    }
    return largest;
  }

  private double[] linear() {
    return new double[] {xx, xy, xz, yx, yy, yz, zx, zy, zz};
  }

  private double[] back() {
    return new double[] {backXx, backXy, backXz, backYx, backYy, backYz, backZx, backZy, backZz};
  }

  private Vector3d column(int i) {
    double[] m = linear();
    return new Vector3d(m[i], m[3 + i], m[6 + i]);
  }

  private static double[] diagonal(double x, double y, double z) {
    return new double[] {x, 0, 0, 0, y, 0, 0, 0, z};
  }

  private static void requireInvertible(double factor) {
    if (!(Double.isFinite(factor) && factor != 0 && Double.isFinite(1 / factor))) {
      throw new ArithmeticException("a scale factor must be finite and not zero, but is " + factor);
    }
  }

  private static double[] product(double[] a, double[] b) {
    double[] c = new double[9];
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        c[3 * row + column] = dotRow(a, row, b[column], b[3 + column], b[6 + column]);
      }
    }
    return c;
  }

  private static double dotRow(double[] m, int row, double x, double y, double z) {
    return m[3 * row] * x + m[3 * row + 1] * y + m[3 * row + 2] * z;
  }

  /** The signed 2×2 minor of an element, indices taken cyclically. */
  private static double cofactor(double[] m, int row, int column) {
    int r1 = 3 * ((row + 1) % 3);
    int r2 = 3 * ((row + 2) % 3);
    int c1 = (column + 1) % 3;
    int c2 = (column + 2) % 3;
    return m[r1 + c1] * m[r2 + c2] - m[r1 + c2] * m[r2 + c1];
  }
}
