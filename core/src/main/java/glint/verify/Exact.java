package glint.verify;

import java.math.BigDecimal;
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

  /** Returns the nearest double, or a neighbour of it. */
  static double toDouble(BigDecimal v) {
    return v.round(FEW).doubleValue();
  }
}
