package glint.render;

/**
 * Foretells how long a render to an error will take, from how it went so far; thread-safe.
 *
 * <p>First all tiles are traced once; then the error falls, at first faster and then as a power of
 * the time.
 */
public final class Outlook {

  /** What follows on the tiles, in times of them, as long as nothing is known of it. */
  private static final double REST = 0.7;

  /** The error falls as some power of the time: this one, as long as nothing is known of it. */
  private static final double POWER = 1;

  /** A guess never says that more than this part is done. */
  private static final double ALMOST = 0.95;

  /** Of a time longer than this, in seconds, nothing is said: it is a wild guess. */
  private static final double LONGEST = 36_000;

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
   * @param target the error at which the render ends, in levels, above 0; infinite if any will do
   */
  public Outlook(double target) {
    this.target = target;
  }

  /** A part of the tiles is finished, 0 to 1, after so many seconds. */
  public synchronized void tiles(double part, double seconds) {
    total = seconds / part * (1 + REST);
  }

  /** The error has come down to so many levels, after so many seconds. */
  public synchronized void error(double error, double seconds) {
    double power = POWER;
    if (lastError < Double.POSITIVE_INFINITY && error > 0 && seconds > lastSeconds) {
      power = StrictMath.log(lastError / error) / StrictMath.log(seconds / lastSeconds);
      power = Math.max(LEAST_POWER, Math.min(GREATEST_POWER, power));
    }
    total = seconds * StrictMath.pow(Math.max(1, error / target), 1 / power);
    lastError = error;
    lastSeconds = seconds;
  }

  /** Returns the part of the work that is done after so many seconds; never less than before. */
  public synchronized double done(double seconds) {
    done = Math.max(done, seconds < ALMOST * total ? seconds / total : ALMOST);
    return done;
  }

  /** Returns the seconds that are left after so many; infinite if that cannot be told. */
  public synchronized double left(double seconds) {
    double left = total - seconds;
    return left > LONGEST ? Double.POSITIVE_INFINITY : Math.max(0, left);
  }
}
