package glint.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.verify.HardCase.Effort;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every row of {@code glint verify} is right. */
class HardCasesTest {

  static List<HardCase> cases() {
    return HardCases.all();
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("cases")
  void passes(HardCase c) {
    Outcome row = c.run(Effort.SHORT);
    assertTrue(row.passed(), row.toString());
  }

  @Tag("soak")
  @ParameterizedTest(name = "{0}")
  @MethodSource("cases")
  void passesAtLength(HardCase c) {
    Outcome row = c.run(Effort.LONG);
    assertTrue(row.passed(), row.toString());
  }

  @Test
  void identifiersAreUnique() {
    Set<String> seen = new HashSet<>();
    cases().forEach(c -> assertTrue(seen.add(c.id()), c.id()));
  }

  @Test
  void runningAgainGivesTheSameRow() {
    HardCase some = cases().stream().filter(c -> c.id().equals("ADV-sphere")).findAny().get();
    assertEquals(some.run(Effort.SHORT), some.run(Effort.SHORT));
  }
}
