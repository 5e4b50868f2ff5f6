package glint.verify;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;

/**
 * Arithmetic that decides every sign: a finite double is an exact decimal, and sums, differences
 * and products of decimals are exact. Only quotients and roots round, to sixty digits.
 */
final class Exact {

  /** How roots and quotients are rounded. */
  static final MathContext DIGITS = new MathContext(60);

  private static final BigDecimal HALF = new BigDecimal("0.5");
  private static final MathContext FEW = new MathContext(20);

  /** Powers of ten from the zeroth on, as numbers of 1 to 2 times powers of two. */
  private static final int POWERS = 1200;

  private static final double[] MANTISSA = new double[POWERS];
  private static final int[] EXPONENT = new int[POWERS];

  static {
    BigInteger power = BigInteger.ONE;
    for (int i = 0; i < POWERS; i++) {
      int shift = Math.max(0, power.bitLength() - 62);
      double leading = power.shiftRight(shift).longValue();
      EXPONENT[i] = Math.getExponent(leading) + shift;
      MANTISSA[i] = Math.scalb(leading, shift - EXPONENT[i]);
      power = power.multiply(BigInteger.TEN);
    }
  }

  private Exact() {}

  static BigDecimal of(double v) {
    return new BigDecimal(v);
  }

  static BigDecimal square(BigDecimal v) {
    return v.multiply(v);
  }

  static BigDecimal ratio(BigDecimal a, BigDecimal b) {
    return a.divide(b, DIGITS);
  }

  /** Returns the square root to sixty digits: Newton's method doubles sixteen twice. */
  static BigDecimal sqrt(BigDecimal v) {
    if (v.signum() == 0) {
      return BigDecimal.ZERO;
    }
    int half = Math.floorDiv(v.precision() - v.scale(), 2);
    BigDecimal reduced = v.scaleByPowerOfTen(-2 * half);
    BigDecimal root = of(Math.sqrt(toDouble(reduced)));
    for (int i = 0; i < 2; i++) {
      root = root.add(ratio(reduced, root)).multiply(HALF, DIGITS);
    }
    return root.scaleByPowerOfTen(half);
  }

  /**
   * Returns a double within 2 ulp: the leading 62 bits over those of a power of ten, which is three
   * times as fast as the nearest one.
   */
  static double toDouble(BigDecimal v) {
    int scale = v.scale();
    if (scale < 0 || scale >= POWERS) {
      return v.round(FEW).doubleValue();
    }
    BigInteger digits = v.unscaledValue();
    int shift = Math.max(0, digits.bitLength() - 62);
    double leading = digits.shiftRight(shift).longValue();
    return Math.scalb(leading / MANTISSA[scale], shift - EXPONENT[scale]);
  }
}
