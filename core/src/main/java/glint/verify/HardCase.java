package glint.verify;

import java.util.function.Function;

/**
 * A case that renderers get wrong, with an answer that decides it.
 *
 * @param id its identifier
 * @param what what is tried, in one line
 * @param run runs it at an effort and returns the row
 */
public record HardCase(String id, String what, Function<Effort, Outcome> run) {

  /** How much work a case may take. */
  public enum Effort {
    /** A share of a second: what every test run does. */
    SHORT,
    /** Up to minutes: {@code glint verify --long} and {@code ./gradlew soak}. */
    LONG
  }
}
