package glint.optics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.Rounding;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Cases R02, R03, R04 and the values that every textbook has. */
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

  @Test
  void reflectedAndTransmittedLightAddUp() {
    SplittableRandom random = new SplittableRandom(3);
    double worst = 0;
    for (int i = 0; i < 1_000_000; i++) {
      double eta = StrictMath.pow(4, 2 * random.nextDouble() - 1);
      double cos =
          switch (i % 4) {
            case 0 -> random.nextDouble();
            case 1 -> StrictMath.pow(10, -12 * random.nextDouble());
            case 2 -> 1 - StrictMath.pow(10, -16 * random.nextDouble());
            default -> {
              // Near the critical angle, if there is one.
              double critical = eta > 1 ? Math.sqrt(1 - 1 / (eta * eta)) : 0.5;
              yield Math.min(1, critical * (1 + 1e-9 * (random.nextDouble() - 0.5)));
            }
          };
      double cosOut = Fresnel.cosOut(cos, eta);
      double r = Fresnel.reflectance(cos, cosOut, eta);
      double t = Fresnel.transmittance(cos, cosOut, eta);
      assertTrue(r >= 0 && r <= 1);
      worst = Math.max(worst, Math.abs(r + t - 1));
    }
    assertTrue(worst <= 8 * Rounding.U, "R + T is off by " + worst / Rounding.U + " u");
  }

  @Test
  void totalReflectionBeginsAtTheCriticalAngle() {
    double critical = StrictMath.asin(1 / 1.5);
    double below = StrictMath.cos(critical - 1e-12);
    double above = StrictMath.cos(critical + 1e-12);
    assertTrue(Fresnel.cosOut(below, 1.5) > 0);
    assertTrue(reflectance(below, 1.5) < 1);
    assertEquals(-1, Fresnel.cosOut(above, 1.5));
    assertEquals(1, reflectance(above, 1.5));
  }

  @Test
  void lightTakesTheSameWayBack() {
    for (int i = 1; i < 1000; i++) {
      double cos = i / 1000.0;
      double cosOut = Fresnel.cosOut(cos, 1 / 1.5);
      double tolerance = cos > 0.1 ? 1e-14 : 1e-8;
      assertEquals(reflectance(cos, 1 / 1.5), reflectance(cosOut, 1.5), tolerance);
    }
  }
}
