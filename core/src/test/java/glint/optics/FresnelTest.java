package glint.optics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** The values that every textbook has; {@code glint verify} tries the rest (R02 to R04, R12). */
class FresnelTest {

  private static double reflectance(double cos, double eta) {
    return Fresnel.reflectance(cos, Fresnel.cosOut(cos, eta), eta);
  }

  @Test
  void textbookValues() {
    assertEquals(0.04, reflectance(1, 1 / 1.5), 1e-16);
    assertEquals(0.04, reflectance(1, 1.5), 1e-16);
    double brewster = 1 / Math.sqrt(1 + 1.5 * 1.5);
    double expected = StrictMath.pow((2.25 - 1) / (2.25 + 1), 2) / 2;
    assertEquals(expected, reflectance(brewster, 1 / 1.5), 1e-16);
    assertEquals(1, reflectance(0, 1 / 1.5));
    assertEquals(0, reflectance(0.3, 1));
  }
}
