package glint.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class TransformTest {

  private static final Vector3d X = new Vector3d(1, 0, 0);

  @Test
  void thenAppliesTheFirstMapFirst() {
    Transform map =
        Transform.scale(new Vector3d(2, 3, 4)).then(Transform.translate(new Vector3d(10, 20, 30)));
    assertEquals(new Vector3d(12, 23, 34), map.point(new Vector3d(1, 1, 1)));
    assertEquals(new Vector3d(2, 3, 4), map.direction(new Vector3d(1, 1, 1)));
    assertEquals(new Vector3d(1, 1, 1), map.inverted().point(new Vector3d(12, 23, 34)));
  }

  @Test
  void rotationsTurnCounterClockwise() {
    Transform quarter = Transform.rotate(Quaternion.aboutAxis(new Vector3d(0, 0, 5), 90));
    Vector3d turned = quarter.point(X);
    assertEquals(0, turned.x(), 1e-15);
    assertEquals(1, turned.y(), 1e-15);
  }

  @Test
  void aQuaternionAndItsNegativeAreTheSameMap() {
    Quaternion q = new Quaternion(0.3, -0.5, 0.7, 0.1);
    Quaternion negative = new Quaternion(-q.w(), -q.x(), -q.y(), -q.z());
    Vector3d p = new Vector3d(1.1, -2.2, 3.3);
    assertEquals(Transform.rotate(q).point(p), Transform.rotate(negative).point(p));
  }

  @Test
  void hugeAndTinyQuaternionsNormalise() {
    for (double size : new double[] {1e-300, 1e-200, 1, 1e200, 1e300}) {
      Quaternion q = new Quaternion(size, 0, size, 0);
      assertEquals(Math.sqrt(0.5), q.w(), 2 * Rounding.U);
    }
    assertThrows(ArithmeticException.class, () -> new Quaternion(0, 0, 0, 0));
    assertThrows(ArithmeticException.class, () -> new Quaternion(Double.NaN, 0, 0, 1));
  }

  @Property
  void normalsStaySquareToTheSurface(
      @ForAll @DoubleRange(min = 0.1, max = 10) double sx,
      @ForAll @DoubleRange(min = 0.1, max = 10) double sy,
      @ForAll @DoubleRange(min = -180, max = 180) double degrees) {
    Transform map =
        Transform.scale(new Vector3d(sx, sy, -0.1))
            .then(Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 2, 3), degrees)));
    Vector3d normal = new Vector3d(1, 2, -1).normalized();
    Vector3d tangent = new Vector3d(1, 0, 1);
    Vector3d n = map.normal(normal).normalized();
    Vector3d t = map.direction(tangent).normalized();
    assertEquals(0, n.dot(t), 1e-13);
  }

  @Test
  void aMatrixAndItsInverseCancel() {
    Transform map = Transform.matrix(1, 2, 3, 4, 0, 1, 4, 5, 5, 6, 0, 6);
    Vector3d p = new Vector3d(0.5, -0.25, 3);
    Vector3d back = map.inverted().point(map.point(p));
    assertEquals(0, back.minus(p).length(), 1e-12);
  }

  @Test
  void mapsThatFlattenSpaceAreRefused() {
    assertThrows(ArithmeticException.class, () -> Transform.scale(new Vector3d(1, 0, 1)));
    assertThrows(
        ArithmeticException.class, () -> Transform.matrix(1, 2, 3, 0, 2, 4, 6, 0, 0, 0, 1, 0));
    assertThrows(
        ArithmeticException.class,
        () -> Transform.matrix(1, 0, 0, Double.NaN, 0, 1, 0, 0, 0, 0, 1, 0));
  }

  @Test
  void uniformScaleSeesSimilarities() {
    Transform similarity =
        Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 1, 0), 33))
            .then(Transform.scale(new Vector3d(-3, -3, 3)))
            .then(Transform.translate(new Vector3d(9, 9, 9)));
    assertEquals(3, similarity.uniformScale(), 1e-14);
    assertEquals(0, Transform.scale(new Vector3d(1, 1, 1.0000001)).uniformScale());
    assertTrue(Transform.IDENTITY.isIdentity());
  }

  @Test
  void unitVectorsDoNotDependOnAPowerOfTwo() {
    Vector3d v = new Vector3d(0.1, -0.7, 12.3);
    for (int k = -900; k <= 900; k += 75) {
      double s = Math.scalb(1.0, k);
      assertEquals(v.normalized(), v.times(s).normalized());
    }
    assertThrows(ArithmeticException.class, () -> Vector3d.ZERO.normalized());
  }
}
