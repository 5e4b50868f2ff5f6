package glint.desktop.window;

/**
 * A logarithmic scale; immutable.
 *
 * @param title what its numbers are
 * @param low its lower end, a power of ten
 * @param high its upper end, a power of ten and above low
 */
record Scale(String title, double low, double high) {

  /** Returns where a number stands: 0 at the lower end, 1 at the upper; 0 for none at all. */
  double place(double value) {
    return value > 0 ? Math.log(value / low) / Math.log(high / low) : 0;
  }

  /** Returns a scale of counts that ends above the largest. */
  static Scale counts(String title, double largest) {
    return new Scale(title, 1, Math.pow(10, Math.max(1, Math.ceil(Math.log10(largest)))));
  }
}
