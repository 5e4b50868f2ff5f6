package glint.models.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import org.junit.jupiter.api.Test;

/** Bodies given as functions, and their surfaces. */
class SurfaceNetsTest {

  private static final Vector3d CORNER = new Vector3d(2, 2, 2);
  private static final Solid BALL = Solid.ellipsoid(Vector3d.ZERO, new Vector3d(1, 1, 1));

  private static Shape surface(Solid solid, double cell) {
    Shape shape = SurfaceNets.of(solid, CORNER.negated(), CORNER, cell);
    assertTrue(Measure.isClosed(shape));
    return shape;
  }

  @Test
  void ballHasItsVolumeAndAllPointsOnIt() {
    Shape shape = surface(BALL, 0.1);
    assertEquals(2, Measure.euler(shape));
    for (Vector3d p : shape.points()) {
      assertEquals(1, p.length(), 1e-9);
    }
    double volume = 4 * Math.PI / 3;
    double coarse = volume - Measure.volume(shape);
    double fine = volume - Measure.volume(surface(BALL, 0.05));
    assertTrue(coarse > 0 && coarse < 0.01 * volume);
    assertEquals(4, coarse / fine, 0.4); // of second order
  }

  @Test
  void ringHasAHole() {
    Solid ring =
        p -> {
          double around = Math.sqrt(p.x() * p.x() + p.y() * p.y()) - 1;
          return Math.sqrt(around * around + p.z() * p.z()) - 0.4;
        };
    Shape shape = surface(ring, 0.06);
    assertEquals(0, Measure.euler(shape));
    double volume = 2 * Math.PI * Math.PI * 0.16;
    assertEquals(volume, Measure.volume(shape), 0.01 * volume);
  }

  @Test
  void capsuleAndBoxAreTrueDistances() {
    Solid capsule = Solid.capsule(Vector3d.ZERO, new Vector3d(4, 0, 0), 0.5, 0.25);
    assertEquals(-0.5, capsule.at(Vector3d.ZERO));
    assertEquals(0.625, capsule.at(new Vector3d(2, 1, 0)));
    assertEquals(0.75, capsule.at(new Vector3d(5, 0, 0)));
    Solid box = Solid.box(new Vector3d(1, 2, 3), 0.5);
    assertEquals(-1, box.at(Vector3d.ZERO));
    assertEquals(1, box.at(new Vector3d(0, 3, 0)));
    // Off an edge: to the axis of its rounding, 3 and 4 away, less its radius
    assertEquals(4.5, box.at(new Vector3d(3.5, 5.5, 0)));
  }

  @Test
  void joinedAndCutBodiesAddUp() {
    Solid other = Solid.ellipsoid(new Vector3d(0.8, 0, 0), new Vector3d(0.7, 0.7, 0.7));
    double both = Measure.volume(surface(BALL.with(other, 0), 0.05));
    double left = Measure.volume(surface(BALL.without(other, 0), 0.05));
    double ball = Measure.volume(surface(other, 0.05));
    assertEquals(both, left + ball, 0.01 * both);
    assertTrue(Measure.volume(surface(BALL.with(other, 0.3), 0.05)) > both);
  }

  @Test
  void seamIsFilledByAQuarterOfItsWidth() {
    Solid plane = p -> p.x();
    Solid wall = p -> p.y();
    assertEquals(-0.1, plane.with(wall, 0.4).at(Vector3d.ZERO));
    assertEquals(0, plane.with(wall, 0.4).at(new Vector3d(0, 0.4, 0)));
    assertEquals(0.1, plane.without(p -> -p.y(), 0.4).at(Vector3d.ZERO));
  }

  @Test
  void movedAndMirroredBodies() {
    Solid off = Solid.ellipsoid(new Vector3d(1, 0, 0), new Vector3d(0.5, 0.5, 0.5));
    assertEquals(-0.5, off.mirrored().at(new Vector3d(-1, 0, 0)));
    Transform turn = Transform.rotate(Quaternion.aboutAxis(new Vector3d(0, 0, 1), 90));
    assertEquals(-0.5, off.moved(turn).at(new Vector3d(0, 1, 0)), 1e-12);
  }

  @Test
  void noiseIsBoundedSmoothAndTheSameEverywhere() {
    Noise noise = new Noise(1);
    double least = 1;
    double most = -1;
    for (int i = 0; i < 4000; i++) {
      Vector3d p = new Vector3d(0.37 * i, -0.11 * i, 0.05 * i);
      double v = noise.at(p);
      least = Math.min(least, v);
      most = Math.max(most, v);
      assertEquals(v, noise.at(p.plus(new Vector3d(1e-7, 0, 0))), 1e-6);
    }
    assertTrue(least > -1 && least < -0.6);
    assertTrue(most < 1 && most > 0.6);
    assertEquals(2 * noise.pick(5) - 1, noise.at(new Vector3d(5, 0, 0)), 1e-15);
    assertEquals(noise.at(CORNER) + noise.at(CORNER.times(2)) / 2, noise.octaves(CORNER, 2), 1e-15);
  }
}
