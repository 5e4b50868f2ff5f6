package glint.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class QuaternionTest {

  private static final Vector3d X = new Vector3d(1, 0, 0);
  private static final Vector3d Y = new Vector3d(0, 1, 0);
  private static final Vector3d Z = new Vector3d(0, 0, 1);

  private static void assertTurns(Quaternion q, Vector3d from, Vector3d to) {
    Vector3d off = Transform.rotate(q).direction(from).minus(to);
    assertEquals(0, off.length(), 1e-15, q + " turns " + from + " elsewhere than to " + to);
  }

  @Test
  void eulerTurnsAboutXThenYThenZOfTheWorld() {
    assertTurns(Quaternion.euler(90, 0, 0), Y, Z);
    assertTurns(Quaternion.euler(0, 90, 0), Z, X);
    assertTurns(Quaternion.euler(0, 0, 90), X, Y);
    // y to z about x, from there to x about y, from there to y about z.
    assertTurns(Quaternion.euler(90, 90, 90), Y, Y);
    assertTurns(Quaternion.euler(90, 90, 0), Y, X);
    assertTurns(Quaternion.euler(0, 90, 90), Y, X.negated());
  }

  @Test
  void thenDoesTheFirstTurnFirst() {
    Quaternion aboutX = Quaternion.aboutAxis(X, 90);
    Quaternion aboutY = Quaternion.aboutAxis(Y, 90);
    assertTurns(aboutX.then(aboutY), Y, X);
    assertTurns(aboutY.then(aboutX), Y, Z);
  }

  @Test
  void lookingTurnsZForwardAndYUp() {
    assertTurns(Quaternion.looking(X.times(7), Y), Z, X);
    assertTurns(Quaternion.looking(X.times(7), Y), Y, Y);
    assertTurns(Quaternion.looking(X, Z.plus(X.times(9))), Y, Z);
    assertTurns(Quaternion.looking(Z.negated(), Y), X, X.negated());
    assertThrows(ArithmeticException.class, () -> Quaternion.looking(X, X.times(-2)));
    assertThrows(ArithmeticException.class, () -> Quaternion.looking(Vector3d.ZERO, Y));
  }

  @Property
  void lookingIsPreciseNextToTheZenith(
      @ForAll @IntRange(max = 12) int k, @ForAll @DoubleRange(min = -1, max = 1) double x) {
    Vector3d forward = new Vector3d(x, 1, 0.5);
    Vector3d aside = forward.cross(Z).normalized().times(StrictMath.pow(10, -k));
    Quaternion q = Quaternion.looking(forward, forward.plus(aside));
    assertTurns(q, Z, forward.normalized());
  }

  @Property
  void aMatrixGivesItsQuaternionBack(
      @ForAll @DoubleRange(min = -1, max = 1) double x,
      @ForAll @DoubleRange(min = -1, max = 1) double y,
      @ForAll @DoubleRange(min = -360, max = 360) double degrees) {
    Quaternion q = Quaternion.aboutAxis(new Vector3d(x, y, 0.1), degrees);
    Transform m = Transform.rotate(q);
    Quaternion back = Quaternion.ofAxes(m.direction(X), m.direction(Y), m.direction(Z));
    double same = q.w() * back.w() + q.x() * back.x() + q.y() * back.y() + q.z() * back.z();
    assertEquals(1, Math.abs(same), 4 * Rounding.U);
  }

  @Test
  void slerpGoesTheShorterWayAtEvenSpeed() {
    Quaternion from = Quaternion.aboutAxis(Y, 10);
    Quaternion to = Quaternion.aboutAxis(Y, 250);
    for (int i = 0; i <= 8; i++) {
      double degrees = 10 - 120.0 * i / 8;
      Vector3d there = Transform.rotate(Quaternion.aboutAxis(Y, degrees)).direction(Z);
      assertTurns(from.slerp(to, i / 8.0), Z, there);
    }
    assertSame(from, from.slerp(from, 0.3));
  }
}
