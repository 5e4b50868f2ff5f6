package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Numbers are those of Double.parseDouble, bit for bit. */
class DecimalTest {

  /** Reads a number between other things, which must not matter. */
  private static double read(String text) {
    Decimal decimal = new Decimal();
    byte[] bytes = ("9." + text + " .5e3").getBytes(StandardCharsets.US_ASCII);
    assertTrue(decimal.read(bytes, 2), text);
    assertEquals(2 + text.length(), decimal.end(), text);
    return decimal.value();
  }

  private static void check(String text) {
    long expected = Double.doubleToRawLongBits(Double.parseDouble(text));
    assertEquals(expected, Double.doubleToRawLongBits(read(text)), text);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0",
        "-0",
        "+0",
        "-0.0e0",
        "0e999",
        "0.000",
        "1",
        "+1",
        "-1",
        "1.",
        ".5",
        "-.5",
        "007.5",
        "1e0",
        "1E+5",
        "1.5e-002",
        "-3.0e+007",
        "1e22",
        "1e23",
        "-1e23",
        "1e-22",
        "1e-23",
        "8.5e22",
        "123456789012345678",
        "1234567890123456789",
        "9223372036854775807",
        "9223372036854775808",
        "99999999999999999999",
        "0.1",
        "0.3",
        "0.30000000000000004",
        "3.141592653589793",
        "3.14159265358979323846",
        "0.1000000000000000055511151231257827",
        "9007199254740991",
        "9007199254740992",
        "9007199254740993",
        "9007199254740994",
        "9007199254740992.5",
        "9007199254740993.0000000000000000000001",
        "90071992547409930e-1",
        "9007199254740993e22",
        "4503599627370496.5",
        "4503599627370497.5",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "1e308",
        "1e309",
        "-1e309",
        "1e99999999999999999999",
        "1e-99999999999999999999",
        "4.9e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "2.5e-324",
        "1e-400",
        "5e-310",
        "2.2250738585072011e-308",
        "2.2250738585072012e-308",
        "2.2250738585072014e-308",
        "6.631236846766476e-316",
        "8.41e21",
        "9.8682e-10",
        "0.000000000000000000000000000000001"
      })
  void hardNumbers(String text) {
    check(text);
  }

  /** The point half-way between two doubles, and a digit, far behind, on either side of it. */
  @Property(tries = 2000)
  void halfway(@ForAll("doubles") double value) {
    double low = Math.abs(value);
    if (Double.isInfinite(Math.nextUp(low))) {
      return;
    }
    BigDecimal sum = new BigDecimal(low).add(new BigDecimal(Math.nextUp(low)));
    String half = sum.divide(BigDecimal.valueOf(2)).toPlainString();
    for (String text : new String[] {half, half + (half.contains(".") ? "1" : ".00001")}) {
      check(text);
      check("-" + text);
    }
    check(new BigDecimal(half).subtract(new BigDecimal(low).ulp()).abs().toPlainString());
  }

  @Property(tries = 5000)
  void whatProgramsWrite(@ForAll("doubles") double value, @ForAll("places") int places) {
    check(Double.toString(value));
    check(Float.toString((float) value).replace("Infinity", "1e39"));
    check(String.format(Locale.ROOT, "%." + places + "e", value));
    if (Math.abs(value) < 1e20) {
      check(String.format(Locale.ROOT, "%." + places + "f", value));
    }
  }

  @Property(tries = 20_000)
  void anyDigits(@ForAll("decimals") String text) {
    check(text);
  }

  @Provide
  Arbitrary<Double> doubles() {
    return Arbitraries.longs()
        .map(Double::longBitsToDouble)
        .filter(Double::isFinite)
        .edgeCases(e -> e.add(0.0, -0.0, Double.MIN_VALUE, Double.MAX_VALUE, 0x1p-1022, 0x1p53));
  }

  @Provide
  Arbitrary<Integer> places() {
    return Arbitraries.integers().between(0, 20);
  }

  @Provide
  Arbitrary<String> decimals() {
    Arbitrary<String> sign = Arbitraries.of("", "-", "+");
    Arbitrary<String> digits = Arbitraries.strings().numeric().ofMinLength(1).ofMaxLength(12);
    Arbitrary<String> exponents =
        Arbitraries.integers().between(-45, 45).map(e -> "e" + e).injectNull(0.5).map(e -> "" + e);
    return Combinators.combine(sign, digits, digits, exponents)
        .as((s, a, b, e) -> s + a + "." + b + e.replace("null", ""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "-", "+", ".", "-.", "e5", "1e", "1e+", "1e-", ".e1", "--1", "nan"})
  void whatIsNoNumber(String text) {
    byte[] bytes = (text + "\n").getBytes(StandardCharsets.US_ASCII);
    assertFalse(new Decimal().read(bytes, 0), text);
  }

  /** Java would take these; OBJ files do not mean them. */
  @ParameterizedTest
  @ValueSource(strings = {"1d", "1f", "0x1p3", "1_000", "1,5"})
  void endsWhereTheNumberEnds(String text) {
    Decimal decimal = new Decimal();
    assertTrue(decimal.read((text + "\n").getBytes(StandardCharsets.US_ASCII), 0));
    assertEquals(1, decimal.end());
  }

  @Test
  void longMantissas() {
    StringBuilder text = new StringBuilder("0.");
    for (int i = 1; i < 900; i++) {
      text.append(i * i % 10);
      check(text.toString());
      check(text + "e-300");
    }
  }
}
