package glint.desktop.window;

/**
 * Foretells how long a render to an error will take, from how it went so far; thread-safe.
 *
 * <p>First all tiles are traced once; then the error falls, at first faster and then as a power of
 * the time.
 */
final class Outlook {

  /** What follows on the tiles, in times of them, as long as nothing is known of it. */
  private static final double REST = 0.7;

  /** The error falls as some power of the time: this one, as long as nothing is known of it. */
  private static final double POWER = 1;

  /** A guess never says that more than this part is done. */
  private static final double ALMOST = 0.95;

  private static final double LEAST_POWER = 0.5;
  private static final double GREATEST_POWER = 2;

  private final double target;
  private double total = Double.POSITIVE_INFINITY;
  private double done;
  private double lastSeconds;
  private double lastError = Double.POSITIVE_INFINITY;

  /**
   * Knows nothing yet.
   *
   * @param target the error at which the render ends, in levels
   */
  Outlook(double target) {
    this.target = target;
  }

  /** A part of the tiles is finished, after so many seconds. */
  synchronized void tiles(double part, double seconds) {
    total = seconds / part * (1 + REST);
  }

  /** The error has come down, after so many seconds. */
  synchronized void error(double error, double seconds) {
    double power = POWER;
    if (lastError < Double.POSITIVE_INFINITY && seconds > lastSeconds) {
      power = Math.log(lastError / error) / Math.log(seconds / lastSeconds);
      power = Math.max(LEAST_POWER, Math.min(GREATEST_POWER, power));
    }
    total = seconds * Math.pow(Math.max(1, error / target), 1 / power);
    lastError = error;
    lastSeconds = seconds;
  }

  /** Returns the part of the work that is done after so many seconds; never less than before. */
  synchronized double done(double seconds) {
    done = Math.max(done, Math.min(ALMOST, seconds / total));
    return done;
  }

  /** Returns the seconds that are left after so many; infinite while nothing is known. */
  synchronized double left(double seconds) {
    return Math.max(0, total - seconds);
  }
}
