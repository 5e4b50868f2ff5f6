package glint.io;

import glint.math.BadValueException;
import glint.optics.Layout;
import glint.optics.Wrap;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Reads what follows the word {@code map_Kd}: a file's name, which may hold blanks, with options
 * before or after it.
 */
final class MtlMapReader {

  /** Options with numbers, and the most of them that each takes. */
  private static final Map<String, Integer> NUMBERS =
      Map.of("-o", 3, "-s", 3, "-t", 3, "-mm", 2, "-bm", 1, "-boost", 1);

  /** Options with one word. */
  private static final Set<String> WORDS =
      Set.of("-blendu", "-blendv", "-cc", "-clamp", "-imfchan", "-texres", "-type", "-colorspace");

  private final String text;
  private final Place place;
  private final Consumer<String> idle;
  private final Decimal decimal = new Decimal();
  private int at;

  private final double[] offset = {0, 0, 0};
  private final double[] scale = {1, 1, 1};
  private final double[] range = {0, 1};
  private boolean clamp;

  private MtlMapReader(String text, Place place, Consumer<String> idle) {
    this.idle = idle;
    this.text = text;
    this.place = place;
  }

  /**
   * Reads the rest of a statement.
   *
   * @param idle is told of options without effect
   * @throws BadObj if an option lacks its value, or has a bad one, or the file's name is missing
   */
  static MtlMap read(String text, Place place, Consumer<String> idle) {
    return new MtlMapReader(text, place, idle).map();
  }

  private MtlMap map() {
    readOptions();
    int begin = at;
    int end = begin;
    // The name ends where an option begins.
    while (at < text.length() && !isOption(peek())) {
      at += peek().length();
      end = at;
      skipBlanks();
    }
    String file = text.substring(begin, end).replace('\\', '/');
    readOptions();
    if (file.isEmpty()) {
      throw new BadObj(place, "map_Kd needs the name of an image");
    }
    if (at < text.length()) {
      throw new BadObj(
          place, "map_Kd has " + SourceText.quote(peek()) + " behind its options, which is none");
    }
    try {
      Wrap wrap = clamp ? Wrap.CLAMP : Wrap.REPEAT;
      Layout layout = new Layout(scale[0], scale[1], offset[0], offset[1], wrap);
      return new MtlMap(file, place.line(), place.column(), layout, range[0], range[1]);
    } catch (BadValueException e) {
      throw new BadObj(place, "map_Kd: " + e.getMessage());
    }
  }

  private static boolean isOption(String word) {
    return NUMBERS.containsKey(word) || WORDS.contains(word);
  }

  private void readOptions() {
    while (at < text.length() && isOption(peek())) {
      String option = next();
      if (WORDS.contains(option)) {
        String value = need(option);
        if (option.equals("-clamp")) {
          clamp = value.equals("on");
        } else {
          idle.accept(option);
        }
      } else {
        readNumbers(option);
      }
    }
  }

  private void readNumbers(String option) {
    double[] values =
        switch (option) {
          case "-o" -> offset;
          case "-s" -> scale;
          case "-mm" -> range;
          default -> {
            idle.accept(option);
            yield new double[3];
          }
        };
    int count = 0;
    while (count < NUMBERS.get(option) && at < text.length() && isNumber(peek())) {
      values[count++] = decimal.value();
      next();
    }
    if (count == 0) {
      throw new BadObj(place, "option " + option + " of map_Kd needs a number");
    }
  }

  private boolean isNumber(String word) {
    byte[] bytes = (word + '\n').getBytes(StandardCharsets.UTF_8);
    return decimal.read(bytes, 0)
        && decimal.end() == bytes.length - 1
        && !Double.isInfinite(decimal.value());
  }

  private String need(String option) {
    if (at == text.length()) {
      throw new BadObj(place, "option " + option + " of map_Kd needs a value");
    }
    return next();
  }

  /** Returns the next word and stays before it. */
  private String peek() {
    int end = at;
    while (end < text.length() && !isBlank(text.charAt(end))) {
      end++;
    }
    return text.substring(at, end);
  }

  private String next() {
    String word = peek();
    at += word.length();
    skipBlanks();
    return word;
  }

  private void skipBlanks() {
    while (at < text.length() && isBlank(text.charAt(at))) {
      at++;
    }
  }

  private static boolean isBlank(char c) {
    return c == ' ' || c == '\t' || c == 0x0B || c == '\f';
  }
}
