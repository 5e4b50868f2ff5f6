package glint.models;

/** Numbers as the files have them: four decimals at most. */
final class Numbers {

  private static final double UNITS = 1e4;

  private Numbers() {}

  /** Returns the decimal of a number without what it does not need. */
  static String text(double v) {
    long scaled = Math.round(v * UNITS);
    long whole = Math.abs(scaled) / (long) UNITS;
    long part = Math.abs(scaled) % (long) UNITS;
    StringBuilder text = new StringBuilder(scaled < 0 ? "-" : "");
    if (whole > 0 || part == 0) {
      text.append(whole);
    }
    if (part > 0) {
      text.append('.').append(String.valueOf((long) UNITS + part).substring(1));
      while (text.charAt(text.length() - 1) == '0') {
        text.setLength(text.length() - 1);
      }
    }
    return text.toString();
  }
}
