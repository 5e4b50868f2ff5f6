package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.io.YamlNode.Scalar;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Text without quotes means what the core schema of YAML 1.2 says (section 10.3.2), except that
 * numbers are decimal.
 */
class YamlNodeTest {

  private static Scalar plain(String text) {
    return new Scalar(Place.NONE, text, true);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "~", "null", "Null", "NULL"})
  void nothing(String text) {
    assertTrue(plain(text).isNull());
    assertEquals("nothing", plain(text).described());
  }

  @ParameterizedTest
  @ValueSource(strings = {"true", "True", "TRUE", "false", "False", "FALSE"})
  void booleans(String text) {
    assertTrue(plain(text).isBoolean());
    assertEquals(text, plain(text).described());
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "-0, -0.0",
    "+12, 12",
    "012, 12",
    "1., 1",
    ".5, 0.5",
    "-.5e1, -5",
    "1e3, 1000",
    "1.25E-2, 0.0125",
    "1e+2, 100",
    "1e-400, 0",
    "123456789012345678901, 123456789012345678901",
  })
  void numbers(String text, double value) {
    assertTrue(plain(text).isNumber());
    assertEquals(value, plain(text).number());
    assertEquals("the number " + text, plain(text).described());
  }

  @ParameterizedTest
  @ValueSource(strings = {".inf", "-.Inf", "+.INF", ".nan", ".NaN", ".NAN", "1e400", "-1e999"})
  void numbersThatAreNone(String text) {
    assertTrue(plain(text).isNumber());
    assertTrue(Double.isNaN(plain(text).number()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "nULL", "none", "yes", "no", "on", "tRUE", "1_000", "1,5", "0x10", "0o7", "1e", "e5", ".",
        "+", "-", "--1", "1.2.3", "1f", "Infinity", "NaN", "nan", "inf", "+.nan", "٣", " 1", "1 m",
      })
  void anythingElseIsText(String text) {
    assertTrue(plain(text).isText());
    assertEquals("the text '" + text + "'", plain(text).described());
  }

  @Test
  void quotesMakeText() {
    for (String text : new String[] {"", "~", "true", "1", ".inf"}) {
      assertTrue(new Scalar(Place.NONE, text, false).isText());
    }
  }
}
