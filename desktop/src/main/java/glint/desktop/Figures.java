package glint.desktop;

import java.util.Locale;

/** Writes figures for people. */
final class Figures {

  private Figures() {}

  /** Returns a rate such as "12.4 M rays/s". */
  static String rate(long rays, double seconds) {
    double rate = rays / Math.max(seconds, 1e-9);
    return rate >= 1e6
        ? String.format(Locale.ROOT, "%.1f M rays/s", rate * 1e-6)
        : String.format(Locale.ROOT, "%.1f k rays/s", rate * 1e-3);
  }

  /** Returns a time such as "2.31 s". */
  static String seconds(double seconds) {
    return String.format(Locale.ROOT, "%.2f s", seconds);
  }

  /** Returns a time to wait for, such as "0:07" or "1:02:03". */
  static String clock(double seconds) {
    long s = Math.round(seconds);
    return s < 3600
        ? String.format(Locale.ROOT, "%d:%02d", s / 60, s % 60)
        : String.format(Locale.ROOT, "%d:%02d:%02d", s / 3600, s / 60 % 60, s % 60);
  }

  /** Returns "1 scene" or "3 scenes". */
  static String count(long n, String what) {
    return n + " " + what + (n == 1 ? "" : "s");
  }
}
