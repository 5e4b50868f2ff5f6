package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SuggestionTest {

  private static final List<String> WORDS =
      List.of("center", "radius", "material", "up", "fov", "look_at", "glass", "scale");

  @ParameterizedTest
  @CsvSource({
    "glas, glass", // a letter lost
    "glasss, glass", // a letter inserted
    "grass, glass", // a wrong letter
    "centre, center", // two letters swapped
    "lookAt, look_at",
    "RADIUS, radius",
    "matreial, material",
    "materiel, material",
    "pu, up",
    "fovy, fov",
    "scales, scale",
  })
  void aTypingErrorIsSeen(String word, String meant) {
    assertEquals(meant, Suggestion.nearest(word, WORDS));
    assertEquals("; did you mean '" + meant + "'?", Suggestion.hint(word, WORDS));
  }

  @ParameterizedTest
  @CsvSource({
    "velocity",
    "x",
    "xy",
    "gas tank",
    "diameter",
    "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"
  })
  void anotherWordIsNone(String word) {
    assertNull(Suggestion.nearest(word, WORDS));
    assertEquals("", Suggestion.hint(word, WORDS));
  }

  @Test
  void theNearestWins() {
    assertEquals("scale", Suggestion.nearest("scal", List.of("scalar", "scale", "seal")));
    assertNull(Suggestion.nearest("", WORDS));
  }

  @Test
  void theListIsShort() {
    List<String> twenty = java.util.Collections.nCopies(20, "a-long-name");
    assertEquals("; known here: a, b", Suggestion.hintOrList("velocity", List.of("a", "b")));
    assertEquals("", Suggestion.hintOrList("velocity", List.of()));
    assertEquals(
        "; known here: " + "a-long-name, ".repeat(14) + "a-long-name and 5 more",
        Suggestion.hintOrList("velocity", twenty));
  }
}
