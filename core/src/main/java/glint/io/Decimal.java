package glint.io;

import java.nio.charset.StandardCharsets;

/**
 * Reads decimal numbers from bytes, each as exactly the double that Double.parseDouble makes of it.
 *
 * <p>Where digits and power of ten are exact doubles, their one product or quotient is rounded
 * right (W. Clinger, How to Read Floating Point Numbers Accurately, PLDI 1990); the rest is left to
 * Java. Written for one number after another: the last one is kept in fields.
 */
final class Decimal {

  /** The greatest number of digits that a long takes for certain. */
  private static final int MOST_DIGITS = 18;

  private static final long LARGEST_EXACT = 1L << 53;
  private static final int LARGEST_EXPONENT = 9999;

  /** The powers of ten that are exact doubles. */
  private static final double[] TEN = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22
  };

  private double value;
  private int end;

  /** Returns the number that was read last; infinite if it is too large for a double. */
  double value() {
    return value;
  }

  /** Returns where the number that was read last ended. */
  int end() {
    return end;
  }

  /**
   * Reads {@code [+-] digits [. digits] [e [+-] digits]}, where digits may lack on one side of the
   * point, up to the first byte that does not belong to it.
   *
   * @param bytes some byte at or after {@code from} is no digit
   * @return whether a number begins at {@code from}
   */
  boolean read(byte[] bytes, int from) {
    int i = from;
    boolean negative = bytes[i] == '-';
    if (negative || bytes[i] == '+') {
      i++;
    }
    long mantissa = 0;
    int first = i;
    while (isDigit(bytes[i])) {
      mantissa = 10 * mantissa + bytes[i++] - '0';
    }
    int digits = i - first;
    int exponent = 0;
    if (bytes[i] == '.') {
      int point = i++;
      while (isDigit(bytes[i])) {
        mantissa = 10 * mantissa + bytes[i++] - '0';
      }
      exponent = point + 1 - i;
      digits -= exponent;
    }
    if (digits == 0) {
      return false;
    }
    if (bytes[i] == 'e' || bytes[i] == 'E') {
      int written = exponent(bytes, i + 1);
      if (end < 0) {
        return false;
      }
      exponent += written;
      i = end;
    }
    end = i;
    boolean fast = digits <= MOST_DIGITS && mantissa <= LARGEST_EXACT;
    if (fast && exponent <= 0 && exponent >= -22) {
      value = mantissa / TEN[-exponent];
    } else if (fast && exponent > 0 && exponent <= 22) {
      value = mantissa * TEN[exponent];
    } else {
      value = Double.parseDouble(new String(bytes, from, i - from, StandardCharsets.US_ASCII));
      return true;
    }
    value = negative ? -value : value;
    return true;
  }

  /** Returns an exponent and sets {@code end}, to -1 if there is none. */
  private int exponent(byte[] bytes, int from) {
    int i = from;
    boolean negative = bytes[i] == '-';
    if (negative || bytes[i] == '+') {
      i++;
    }
    int first = i;
    int exponent = 0;
    while (isDigit(bytes[i])) {
      exponent = Math.min(LARGEST_EXPONENT, 10 * exponent + bytes[i++] - '0');
    }
    end = i == first ? -1 : i;
    return negative ? -exponent : exponent;
  }

  private static boolean isDigit(byte b) {
    return b >= '0' && b <= '9';
  }
}
