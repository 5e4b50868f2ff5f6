package glint.verify;

import java.util.function.Consumer;

/** A case that renderers get wrong, with an answer that decides it; immutable. */
public final class HardCase {

  /** How much work a case may take. */
  public enum Effort {
    /** A share of a second: what every test run does. */
    SHORT,
    /** Up to minutes: {@code glint verify --long} and {@code ./gradlew soak}. */
    LONG
  }

  private final String id;
  private final String what;
  private final double bound;
  private final String unit;
  private final Consumer<Tally> trials;

  private HardCase(String id, String what, double bound, String unit, Consumer<Tally> trials) {
    this.id = id;
    this.what = what;
    this.bound = bound;
    this.unit = unit;
    this.trials = trials;
  }

  /** Makes a case whose answers are only right or wrong. */
  static HardCase exact(String id, String what, Consumer<Tally> trials) {
    return new HardCase(id, what, 0, "-", trials);
  }

  /** Makes a case whose errors have a bound. */
  static HardCase within(
      String id, String what, double bound, String unit, Consumer<Tally> trials) {
    return new HardCase(id, what, bound, unit, trials);
  }

  /** Makes a case whose errors have a bound that was derived elsewhere. */
  static HardCase within(String id, String what, Bound bound, Consumer<Tally> trials) {
    return within(id, what, bound.most(), bound.unit(), trials);
  }

  /** Returns the identifier, such as S05. */
  public String id() {
    return id;
  }

  /** Returns what is tried, in one line. */
  public String what() {
    return what;
  }

  /** Runs all trials; every run at the same effort gives the same row. */
  public Outcome run(Effort effort) {
    Tally tally = new Tally(effort);
    trials.accept(tally);
    return new Outcome(id, what, tally.tried(), tally.wrong(), tally.worst(), bound, unit);
  }

  /** Returns the identifier. */
  @Override
  public String toString() {
    return id;
  }
}
