package glint.models.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.Transform;
import glint.math.Vector3d;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Surfaces that are turned, lofted and swept. */
class ShapeTest {

  private static final Vector3d UP = new Vector3d(0, 1, 0);

  /** A prism over a regular polygon: base times height, exactly. */
  private static double prism(int corners, double radius, double height) {
    double angle = 2 * Math.PI / corners;
    return corners * radius * radius * Math.sin(angle) / 2 * height;
  }

  private static void assertBall(double volume, Shape shape) {
    assertTrue(Measure.isClosed(shape));
    assertEquals(2, Measure.euler(shape));
    assertEquals(volume, Measure.volume(shape), 1e-12 * volume);
  }

  @Test
  void latheTurnsCylinderAndCone() {
    assertBall(prism(12, 2, 5), Lathe.body(12, 0, 1, 2, 1, 2, 6, 0, 6));
    assertBall(prism(7, 3, 4) / 3, Lathe.body(7, 0, 0, 3, 0, 0, 4));
  }

  @Test
  void latheTurnsAnOpenTube() {
    Shape tube = Lathe.tube(16, 1, 0, 1, 2);
    assertFalse(Measure.isClosed(tube));
    assertEquals(0, Measure.euler(tube));
    assertEquals(16 * 2 * 2 * Math.sin(Math.PI / 16), Measure.area(tube), 1e-12);
  }

  @Test
  void latheWantsItsEndsOnTheAxis() {
    assertThrows(IllegalArgumentException.class, () -> Lathe.body(8, 1, 0, 1, 1, 0, 1));
  }

  @Test
  void loftWantsRowsThatMatch() {
    List<List<Vector3d>> rows = List.of(Lathe.ring(5, 1, 0), Lathe.ring(6, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> Loft.tube(rows));
  }

  @Test
  void sweepAlongALineIsAPrism() {
    Vector3d from = new Vector3d(1, 2, 3);
    Vector3d to = new Vector3d(3, 5, 9);
    assertBall(prism(9, 0.5, 7), Sweep.tube(List.of(from, to), 9, t -> 0.5));
  }

  @Test
  void sweepAlongACurveKeepsItsThickness() {
    List<Vector3d> curve =
        Spline.through(20, Vector3d.ZERO, UP, new Vector3d(1, 2, 0), new Vector3d(1, 3, 1));
    Shape tube = Sweep.tube(curve, 24, t -> 0.1);
    double length = 0;
    for (int i = 1; i < curve.size(); i++) {
      length += curve.get(i).minus(curve.get(i - 1)).length();
    }
    assertTrue(Measure.isClosed(tube));
    // Pappus: the area of the section times the way of its middle.
    assertEquals(prism(24, 0.1, length), Measure.volume(tube), 2e-3 * prism(24, 0.1, length));
  }

  @Test
  void splineGoesThroughItsKnotsAndAlongALine() {
    Vector3d[] knots = {Vector3d.ZERO, UP, UP.times(2), UP.times(3)};
    List<Vector3d> curve = Spline.through(4, knots);
    assertEquals(13, curve.size());
    for (int i = 0; i < knots.length; i++) {
      assertEquals(knots[i], curve.get(4 * i));
    }
    // Between inner knots, evenly spaced ones are followed evenly.
    assertEquals(UP.times(1.25), curve.get(5));
  }

  @Test
  void superellipsoidIsAnEllipsoidOrNearlyABox() {
    Vector3d radii = new Vector3d(1, 2, 3);
    Shape ball = Superellipsoid.of(radii, 1, 128, 64);
    Shape box = Superellipsoid.of(radii, 0.02, 128, 64);
    assertTrue(Measure.isClosed(ball));
    assertEquals(2, Measure.euler(ball));
    double whole = 4 * Math.PI / 3 * 6;
    assertTrue(Measure.volume(ball) < whole);
    assertEquals(whole, Measure.volume(ball), 2e-3 * whole);
    assertEquals(48, Measure.volume(box), 2);
  }

  @Test
  void patchHasItsOutsideWhereItsAxesCross() {
    Shape patch = Patch.of(3, 2, (u, v) -> new Vector3d(6 * u, 2 * v, 0));
    assertEquals(6, patch.faces().size());
    assertEquals(12, Measure.area(patch), 1e-12);
    int[] face = patch.faces().get(0);
    Vector3d a = patch.points().get(face[0]);
    Vector3d ab = patch.points().get(face[1]).minus(a);
    Vector3d ac = patch.points().get(face[2]).minus(a);
    assertTrue(ab.cross(ac).z() > 0);
  }

  @Test
  void movedMirroredAndJoinedSurfacesKeepTheirOutside() {
    Shape cone = Lathe.body(7, 0, 0, 3, 0, 0, 4);
    double volume = Measure.volume(cone);
    Shape scaled = cone.moved(Transform.scale(new Vector3d(2, -1, 3)));
    assertEquals(6 * volume, Measure.volume(scaled), 1e-11);
    Shape both = cone.moved(10, 0, 0).withMirrorImage();
    assertEquals(2 * volume, Measure.volume(both), 1e-11);
    assertEquals(4, Measure.euler(both));
    assertEquals(-volume, Measure.volume(cone.reversed()), 1e-12);
  }

  @Test
  void whereDividesASurface() {
    Shape tube = Lathe.tube(8, 1, 0, 1, 1, 1, 2);
    Shape low = tube.where(p -> p.y() < 1);
    Shape high = tube.where(p -> p.y() >= 1);
    assertEquals(8, low.faces().size());
    assertEquals(16, low.points().size());
    assertEquals(8, high.faces().size());
    assertEquals(Measure.area(tube), Measure.area(low) + Measure.area(high), 1e-12);
  }
}
