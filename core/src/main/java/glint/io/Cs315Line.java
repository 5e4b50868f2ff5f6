package glint.io;

import glint.color.Rgb;
import glint.math.BadValueException;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A line of a CS 315 scene: a command and its arguments, which know their columns. */
final class Cs315Line {

  private static final Pattern WORD = Pattern.compile("\\S+");
  private static final Pattern NUMBER =
      Pattern.compile("[-+]?(\\.[0-9]+|[0-9]+(\\.[0-9]*)?)([eE][-+]?[0-9]+)?");

  private final int line;
  private final List<String> words = new ArrayList<>();
  private final List<Integer> columns = new ArrayList<>();
  private final Problems problems;
  private boolean sound = true;

  /** Splits a line at white space, up to a word that begins with {@code #}. */
  Cs315Line(int line, String text, Problems problems) {
    this.line = line;
    this.problems = problems;
    Matcher matcher = WORD.matcher(text);
    while (matcher.find() && text.charAt(matcher.start()) != '#') {
      words.add(matcher.group());
      columns.add(1 + text.codePointCount(0, matcher.start()));
    }
  }

  boolean isEmpty() {
    return words.isEmpty();
  }

  int line() {
    return line;
  }

  String command() {
    return words.get(0);
  }

  int arguments() {
    return words.size() - 1;
  }

  String argument(int i) {
    return words.get(1 + i);
  }

  Place place() {
    return new Place(line, columns.get(0));
  }

  Place argumentPlace(int i) {
    return new Place(line, columns.get(1 + i));
  }

  void report(Place at, String message) {
    problems.report(at, message);
    sound = false;
  }

  /** Returns argument {@code i} as a number, 0 with a problem reported if it is none. */
  double number(int i) {
    String word = argument(i);
    boolean isNumber = NUMBER.matcher(word).matches();
    double value = isNumber ? Double.parseDouble(word) : 0;
    if (!isNumber) {
      report(argumentPlace(i), "expected a number, but found " + SourceText.quote(word));
    } else if (Double.isInfinite(value)) {
      report(argumentPlace(i), "too large a number: " + SourceText.quote(word));
      return 0;
    }
    return value;
  }

  /** Returns argument {@code i} as a whole number, 0 with a problem reported if it is none. */
  int wholeNumber(int i) {
    double value = number(i);
    if (value == Math.rint(value) && Math.abs(value) <= Integer.MAX_VALUE) {
      return (int) value;
    }
    boolean large = Math.abs(value) > Integer.MAX_VALUE;
    report(
        argumentPlace(i),
        "expected a whole number"
            + (large ? " up to " + Integer.MAX_VALUE : "")
            + ", but found "
            + SourceText.quote(argument(i)));
    return 0;
  }

  /**
   * Runs a step that checks this line's values, unless one was bad already; what it finds bad is
   * reported where the line begins.
   */
  void checked(Runnable step) {
    if (!sound) {
      return;
    }
    try {
      step.run();
    } catch (BadValueException | ArithmeticException e) {
      report(place(), e.getMessage());
    }
  }

  Vector3d vector(int first) {
    return new Vector3d(number(first), number(first + 1), number(first + 2));
  }

  Rgb color(int first) {
    return new Rgb(number(first), number(first + 1), number(first + 2));
  }
}
