package glint.io;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.io.YamlNode.Scalar;
import glint.io.YamlNode.Sequence;
import glint.math.BadValueException;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import java.util.regex.Pattern;

/**
 * Reads single values; what is wrong is reported and a harmless value returned, so that reading
 * goes on to the next problem.
 *
 * <p>A null node stands for a value whose absence was reported before.
 */
final class Values {

  private static final Pattern HEX = Pattern.compile("#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})");

  private final Problems problems;
  private final Problems notes;

  /** Reports what is wrong, and what is merely worth knowing. */
  Values(Problems problems, Problems notes) {
    this.problems = problems;
    this.notes = notes;
  }

  Problems problems() {
    return problems;
  }

  void report(YamlNode node, String message) {
    problems.report(node.place(), message);
  }

  /** Notes what does no harm, but is hardly meant. */
  void note(YamlNode node, String message) {
    if (notes.takesMore()) {
      notes.report(node.place(), message);
    }
  }

  /** Reports that a value is not what it should be. */
  void wrong(YamlNode node, String expected) {
    String remedy = "";
    if (node instanceof Scalar s && s.isText() && s.looksLikeNumber() && expected.contains("num")) {
      remedy = "; remove the quotes";
    }
    report(node, "expected " + expected + ", but found " + node.described() + remedy);
  }

  /** Returns a value that checks itself, or null with its problem reported at the node. */
  <T> T checked(YamlNode node, Supplier<T> supplier) {
    try {
      return supplier.get();
    } catch (BadValueException | ArithmeticException e) {
      report(node, e.getMessage());
      return null;
    }
  }

  double number(YamlNode node) {
    if (node == null) {
      return 0;
    }
    if (!(node instanceof Scalar scalar && scalar.isNumber())) {
      wrong(node, "a number");
      return 0;
    }
    double value = scalar.number();
    if (Double.isNaN(value)) {
      boolean named = Character.isLetter(scalar.text().charAt(scalar.text().length() - 1));
      report(
          node,
          (named ? "not a finite number: " : "too large a number: ")
              + SourceText.shorten(scalar.text()));
      return 0;
    }
    return value;
  }

  /** Returns what a number makes, or null with its problem reported at the node. */
  <T> T checkedNumber(YamlNode node, DoubleFunction<T> maker) {
    long before = problems.reports();
    double value = number(node);
    return problems.reports() == before ? checked(node, () -> maker.apply(value)) : null;
  }

  int wholeNumber(YamlNode node) {
    if (node == null) {
      return 0;
    }
    if (!(node instanceof Scalar scalar && scalar.isNumber())) {
      wrong(node, "a whole number");
      return 0;
    }
    double value = scalar.number();
    if (value == Math.rint(value) && Math.abs(value) <= Integer.MAX_VALUE) {
      return (int) value;
    }
    boolean large = Math.abs(value) > Integer.MAX_VALUE;
    wrong(node, "a whole number" + (large ? " up to " + Integer.MAX_VALUE : ""));
    return 0;
  }

  boolean flag(YamlNode node) {
    if (!(node instanceof Scalar scalar && scalar.isBoolean())) {
      wrong(node, "true or false");
      return false;
    }
    return Boolean.parseBoolean(scalar.text());
  }

  /** Returns a text; a number or the like must stand in quotes to be one. */
  String text(YamlNode node) {
    if (!(node instanceof Scalar scalar && scalar.isText())) {
      boolean quotable = node instanceof Scalar s && !s.isNull();
      wrong(node, quotable ? "a text in quotes" : "a text");
      return "";
    }
    return scalar.text();
  }

  /** Returns one of some words, the first if it is none of them. */
  String word(YamlNode node, List<String> possible) {
    String text = node instanceof Scalar scalar ? scalar.text() : "";
    if (possible.contains(text)) {
      return text;
    }
    String expected = "expected " + String.join(" or ", possible) + ", but found ";
    report(node, expected + node.described() + Suggestion.hint(text, possible));
    return possible.get(0);
  }

  Vector3d vector(YamlNode node) {
    if (node == null) {
      return Vector3d.ZERO;
    }
    List<Double> n = numbers(node, 3, "[x, y, z]");
    return new Vector3d(n.get(0), n.get(1), n.get(2));
  }

  /** Returns so many numbers from a list, all zero with a problem reported if it is none. */
  List<Double> numbers(YamlNode node, int count, String form) {
    if (!(node instanceof Sequence list && list.items().size() == count)) {
      wrong(node, count + " numbers " + form);
      return Collections.nCopies(count, 0.0);
    }
    List<Double> numbers = new ArrayList<>();
    for (YamlNode item : list.items()) {
      numbers.add(number(item));
    }
    return numbers;
  }

  /** Returns the items of a list, none with a problem reported if it is not a list. */
  List<YamlNode> list(YamlNode node, String of) {
    if (node == null) {
      return List.of();
    }
    if (!(node instanceof Sequence list)) {
      wrong(node, "a list of " + of);
      return List.of();
    }
    return list.items();
  }

  /** Returns a colour: three linear numbers, one for grey, or sRGB codes such as "#ffb300". */
  Rgb color(YamlNode node) {
    if (node == null) {
      return Rgb.BLACK;
    }
    if (node instanceof Sequence) {
      List<Double> n = numbers(node, 3, "[red, green, blue]");
      return new Rgb(n.get(0), n.get(1), n.get(2));
    }
    if (node instanceof Scalar scalar) {
      if (scalar.isNumber()) {
        return Rgb.grey(number(node));
      }
      if (HEX.matcher(scalar.text()).matches()) {
        return decode(scalar.text());
      }
    }
    String form = "a colour: a number, [red, green, blue] or \"#rrggbb\"";
    wrong(node, node.described().equals("nothing") ? form + " in quotes" : form);
    return Rgb.BLACK;
  }

  /** Returns a colour that is light: neither negative nor infinite. */
  Rgb light(String name, YamlNode node) {
    Rgb color = color(node);
    try {
      color.requireLight(name);
      return color;
    } catch (BadValueException e) {
      report(node, e.getMessage());
      return Rgb.BLACK;
    }
  }

  /** Returns a coefficient for each channel, none negative or infinite. */
  Rgb coefficients(String name, YamlNode node) {
    if (node instanceof Sequence || (node instanceof Scalar scalar && scalar.isNumber())) {
      return light(name, node);
    }
    wrong(node, "a number or 3 numbers [red, green, blue]");
    return Rgb.BLACK;
  }

  private static Rgb decode(String hex) {
    double[] linear = new double[3];
    for (int i = 0; i < 3; i++) {
      int code =
          hex.length() == 4
              ? 17 * Character.digit(hex.charAt(1 + i), 16)
              : Integer.parseInt(hex.substring(1 + 2 * i, 3 + 2 * i), 16);
      linear[i] = Transfer.SRGB.decode(code / 255.0);
    }
    return new Rgb(linear[0], linear[1], linear[2]);
  }
}
