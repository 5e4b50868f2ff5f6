package glint.optics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import glint.math.BadValueException;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Where on an image the points of a surface lie. */
class MappingTest {

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static void assertAt(
      double u, double v, Mapping mapping, Vector3d p, int flat, double tolerance) {
    Texel texel = new Texel();
    mapping.find(p.x(), p.y(), p.z(), flat, texel);
    assertEquals(u, texel.u, tolerance, () -> "u at " + p);
    assertEquals(v, texel.v, tolerance, () -> "v at " + p);
  }

  private static void assertAt(double u, double v, Mapping mapping, Vector3d p) {
    assertAt(u, v, mapping, p, Pattern.SOLID, 1e-12);
  }

  private static void assertAt(double u, double v, Mapping mapping, Vector3d p, int flat) {
    assertAt(u, v, mapping, p, flat, 1e-12);
  }

  @Property(tries = 300)
  void planar(
      @ForAll @DoubleRange(min = -9, max = 9) double u,
      @ForAll @DoubleRange(min = -9, max = 9) double v,
      @ForAll @DoubleRange(min = -9, max = 9) double height,
      @ForAll @DoubleRange(min = 10, max = 170) double angle,
      @ForAll @DoubleRange(min = 0.1, max = 9) double length) {
    Transform turn = Transform.rotate(Quaternion.aboutAxis(v(1, 2, 3), 10 * angle));
    Vector3d corner = v(height, -length, 3);
    Vector3d edge1 = turn.direction(v(length, 0, 0));
    double radians = Math.toRadians(angle);
    Vector3d edge2 = turn.direction(v(2 * Math.cos(radians), 2 * Math.sin(radians), 0));
    Vector3d up = turn.direction(v(0, 0, height));
    Vector3d p = corner.plus(edge1.times(u)).plus(edge2.times(v)).plus(up);
    assertAt(u, v, Planar.of(corner, edge1, edge2), p, 2, 1e-10);
  }

  @Test
  void planarOfAnySize() {
    Vector3d corner = v(1, 2, 3);
    Planar huge = Planar.of(corner, v(1e99, 0, 0), v(1e99, 1e99, 0));
    assertAt(0.25, 0.5, huge, v(0.75e99, 0.5e99, 7));
    Planar tiny = Planar.of(Vector3d.ZERO, v(1e-99, 0, 0), v(0, 0, 1e-99));
    assertAt(0.25, 0.5, tiny, v(0.25e-99, 1, 0.5e-99));
    assertThrows(BadValueException.class, () -> Planar.of(corner, v(1, 1, 0), v(-3, -3, 0)));
    assertThrows(BadValueException.class, () -> Planar.of(corner, v(0, 0, 0), v(0, 1, 0)));
  }

  @Test
  void aGlobeHasItsPlaces() {
    Spherical globe = Spherical.around(v(1, 2, 3));
    double r = 0.7;
    Vector3d c = v(1, 2, 3);
    assertAt(0.5, 0.5, globe, c.plus(v(0, 0, r)));
    assertAt(0.75, 0.5, globe, c.plus(v(r, 0, 0)));
    assertAt(0.25, 0.5, globe, c.plus(v(-r, 0, 0)));
    assertAt(0.625, 0.75, globe, c.plus(v(1, Math.sqrt(2), 1)));
    assertAt(0.5, 1, globe, c.plus(v(0, r, 0)));
    assertAt(0.5, 0, globe, c.plus(v(0, -r, 0)));
    assertAt(1, 0.5, globe, c.plus(v(0, 0, -r)));
  }

  @Property(tries = 300)
  void aTurnedGlobeShowsLongitudeAndLatitude(
      @ForAll @DoubleRange(min = 0.01, max = 0.99) double u,
      @ForAll @DoubleRange(min = 0.01, max = 0.99) double v,
      @ForAll @DoubleRange(min = 0, max = 360) double degrees) {
    Transform turn = Transform.rotate(Quaternion.aboutAxis(v(3, -1, 2), degrees));
    Vector3d up = turn.direction(v(0, 5, 0));
    Vector3d front = turn.direction(v(0, 2, 1)); // its part along up does not matter
    Spherical globe = Spherical.of(v(1, 0, 0), up, front);
    double longitude = 2 * Math.PI * (u - 0.5);
    double latitude = Math.PI * (v - 0.5);
    double across = Math.cos(latitude);
    Vector3d p = v(across * Math.sin(longitude), Math.sin(latitude), across * Math.cos(longitude));
    assertAt(u, v, globe, turn.direction(p.times(3)).plus(v(1, 0, 0)), Pattern.SOLID, 1e-10);
  }

  @Test
  void aGlobeNeedsTwoDirections() {
    assertThrows(
        BadValueException.class, () -> Spherical.of(Vector3d.ZERO, v(0, 0, 1), v(0, 0, -2)));
    assertThrows(
        BadValueException.class, () -> Spherical.of(Vector3d.ZERO, v(0, 0, 0), v(0, 1, 0)));
  }

  @Test
  void everyFaceOfABoxIsUpright() {
    Faces box = new Faces(v(-1, -2, -3), v(1, 2, 3));
    // A quarter of the way to the right and three quarters up, seen from outside.
    assertAt(0.25, 0.75, box, v(-0.5, 1, 3), 2);
    assertAt(0.25, 0.75, box, v(0.5, 1, -3), 2);
    assertAt(0.25, 0.75, box, v(1, 1, 1.5), 0);
    assertAt(0.25, 0.75, box, v(-1, 1, -1.5), 0);
    assertAt(0.25, 0.75, box, v(-0.5, 2, -1.5), 1);
    assertAt(0.25, 0.75, box, v(-0.5, -2, 1.5), 1);
  }

  @Test
  void aLabelLiesAroundACan() {
    Around can = Around.of(v(1, 1, 1), v(0, 4, 0), 2, 1);
    assertAt(0.5, 0.25, can, v(1, 2, 2.75));
    assertAt(0.75, 1, can, v(2, 5, 1));
    assertAt(0.25, 0, can, v(-1, 1, 1));
    // The caps, from above and from below.
    assertAt(0.75, 0.5, can, v(1.5, 5, 1), 1);
    assertAt(0.5, 0.25, can, v(1, 5, 1.5), 1);
    assertAt(0.75, 0.5, can, v(2, 1, 1), 1);
    assertAt(0.5, 0.75, can, v(1, 1, 2), 1);
    // Along z the middle is towards y, and to its right lies -x, as z points up.
    Around along = Around.of(Vector3d.ZERO, v(0, 0, 2), 1, 1);
    assertAt(0.5, 0.5, along, v(0, 1, 1));
    assertAt(0.75, 0.5, along, v(-1, 0, 1));
  }

  @Property(tries = 100)
  void aPlaneIsPapered(
      @ForAll @DoubleRange(min = -9, max = 9) double x,
      @ForAll @DoubleRange(min = -9, max = 9) double y,
      @ForAll @DoubleRange(min = -9, max = 9) double z) {
    Assume.that(x != 0 && y != 0 && z != 0);
    assertAt(-z, y, new Flat(), v(x, y, z), 0);
    assertAt(x, -z, new Flat(), v(x, y, z), 1);
    assertAt(x, y, new Flat(), v(x, y, z), 2);
  }
}
