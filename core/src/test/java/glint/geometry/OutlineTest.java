package glint.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

class OutlineTest {

  private static final Vector3d EYE = new Vector3d(3, 4, 9);

  /** Whatever the eye sees of a surface lies between the planes through the eye that touch it. */
  private static void assertHolds(List<Vector3d> outline, Vector3d seen, Random random) {
    for (int i = 0; i < 50; i++) {
      Vector3d n =
          new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      Vector3d d = seen.minus(EYE).normalized();
      double most = Double.NEGATIVE_INFINITY;
      for (Vector3d p : outline) {
        Vector3d toPoint = p.minus(EYE);
        most = Math.max(most, n.cross(d).dot(toPoint) / toPoint.length());
      }
      assertTrue(most >= -1e-12, "beyond the outline by " + most);
    }
  }

  private static Transform bent(Random random) {
    return Transform.scale(new Vector3d(0.3, 1.5, -0.8))
        .then(
            Transform.rotate(
                Quaternion.aboutAxis(new Vector3d(1, 2, 3), 360 * random.nextDouble())))
        .then(Transform.translate(new Vector3d(random.nextDouble(), 0, -2)));
  }

  @Property(tries = 100)
  void anEllipsoidIsHeld(@ForAll long seed) {
    Random random = new Random(seed);
    Transform place = bent(random);
    List<Vector3d> outline = Outline.of(new Sphere(new Vector3d(1, 0, 0), 2), place, EYE);
    Vector3d n = new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    Vector3d on = new Vector3d(1, 0, 0).plus(n.normalized().times(2));
    assertHolds(outline, place.point(on), random);
  }

  @Property(tries = 100)
  void aConeIsHeld(@ForAll long seed) {
    Random random = new Random(seed);
    Transform place = bent(random);
    Cylinder cone = new Cylinder(Vector3d.ZERO, new Vector3d(0, 3, 0), 1, 0.25, true);
    double angle = 7 * random.nextDouble();
    double h = random.nextDouble();
    double r = 1 - 0.75 * h;
    Vector3d on = new Vector3d(r * Math.cos(angle), 3 * h, r * Math.sin(angle));
    assertHolds(Outline.of(cone, place, EYE), place.point(on), random);
  }

  @Test
  void aThinCylinderIsAsWideAsItIs() {
    Vector3d eye = new Vector3d(0, 0, 1e6);
    Cylinder wire = new Cylinder(Vector3d.ZERO, new Vector3d(5, 5, 0), 0.1, 0.1, false);
    double most = 0;
    for (Vector3d p : Outline.of(wire, Transform.IDENTITY, eye)) {
      most = Math.max(most, Math.abs(p.x() - p.y()) / Math.sqrt(2));
    }
    assertEquals(0.1, most, 1e-6);
  }

  @Test
  void whatHasNoEndHasNoOutline() {
    Vector3d up = new Vector3d(0, 1, 0);
    assertTrue(Outline.of(new Plane(Vector3d.ZERO, up), Transform.IDENTITY, EYE).isEmpty());
    assertTrue(Outline.of(new Sphere(EYE, 1), Transform.IDENTITY, EYE).isEmpty());
  }
}
