package glint.desktop.report;

import java.util.function.IntFunction;

/**
 * A logarithmic axis over whole decades, from 10^low at its start to 10^high at its end.
 *
 * @param words writes a power of ten, given its exponent
 */
record LogAxis(int low, int high, IntFunction<String> words) {

  /** Returns the shortest axis of at least one decade that holds both of two positive values. */
  static LogAxis around(double least, double most, IntFunction<String> words) {
    int low = (int) Math.floor(Math.log10(least));
    int high = (int) Math.ceil(Math.log10(most));
    return new LogAxis(low, Math.max(high, low + 1), words);
  }

  /** Returns where a value lies: 0 at the start, 1 at the end. */
  double place(double value) {
    return (Math.log10(value) - low) / (high - low);
  }
}
