package glint.desktop.report;

import java.math.BigDecimal;
import java.math.MathContext;

/** Writes figures for people. */
final class Numbers {

  private static final String[] PREFIXES = {"n", "µ", "m", "", "k", "M", "G", "T", "P"};

  /** Where in the prefixes none stands. */
  private static final int NO_PREFIX = 3;

  private Numbers() {}

  /** Returns a positive figure with three digits and a prefix, such as "12.3 ms". */
  static String prefixed(double value, String unit) {
    double scaled = value;
    int prefix = NO_PREFIX;
    while (scaled >= 999.5 && prefix < PREFIXES.length - 1) {
      scaled /= 1000;
      prefix++;
    }
    while (scaled < 0.9995 && prefix > 0) {
      scaled *= 1000;
      prefix--;
    }
    return (digits(scaled) + " " + PREFIXES[prefix] + unit).trim();
  }

  /** Returns a figure with the three digits that count. */
  static String digits(double value) {
    return new BigDecimal(value).round(new MathContext(3)).toPlainString();
  }
}
