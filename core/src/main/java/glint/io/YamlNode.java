package glint.io;

import java.util.List;
import java.util.regex.Pattern;

/** A value of a YAML file with its place; immutable. */
sealed interface YamlNode {

  /** Returns where the value begins. */
  Place place();

  /** Returns the value's kind, and a short value itself, as in "found the number 5". */
  String described();

  /**
   * Text, or what the core schema of YAML 1.2 makes of text without quotes, numbers being decimal.
   *
   * @param plain whether it stands without quotes
   */
  record Scalar(Place place, String text, boolean plain) implements YamlNode {

    private static final Pattern NULL = Pattern.compile("|~|null|Null|NULL");
    private static final Pattern BOOLEAN = Pattern.compile("true|True|TRUE|false|False|FALSE");
    private static final Pattern NUMBER =
        Pattern.compile(
            "[-+]?(\\.[0-9]+|[0-9]+(\\.[0-9]*)?)([eE][-+]?[0-9]+)?"
                + "|[-+]?\\.(inf|Inf|INF)|\\.(nan|NaN|NAN)");

    boolean isNull() {
      return plain && NULL.matcher(text).matches();
    }

    boolean isBoolean() {
      return plain && BOOLEAN.matcher(text).matches();
    }

    boolean isNumber() {
      return plain && looksLikeNumber();
    }

    boolean isText() {
      return !(isNull() || isBoolean() || isNumber());
    }

    /** Returns whether it is a number, or would be one without its quotes. */
    boolean looksLikeNumber() {
      return NUMBER.matcher(text).matches();
    }

    /** Returns the number; NaN unless it is finite. */
    double number() {
      char last = text.charAt(text.length() - 1);
      double value = Character.isLetter(last) ? Double.NaN : Double.parseDouble(text);
      return Double.isInfinite(value) ? Double.NaN : value;
    }

    @Override
    public String described() {
      if (isNull()) {
        return "nothing";
      }
      if (isNumber()) {
        return "the number " + SourceText.shorten(text);
      }
      return isBoolean() ? text : "the text " + SourceText.quote(text);
    }
  }

  /** A list. */
  record Sequence(Place place, List<YamlNode> items) implements YamlNode {
    @Override
    public String described() {
      return items.isEmpty() ? "an empty list" : "a list of " + items.size();
    }
  }

  /** A map, its keys in file order and not yet checked. */
  record Mapping(Place place, List<Entry> entries) implements YamlNode {
    @Override
    public String described() {
      return entries.isEmpty() ? "an empty map" : "a map";
    }
  }

  /** A key with its value. */
  record Entry(YamlNode key, YamlNode value) {}
}
