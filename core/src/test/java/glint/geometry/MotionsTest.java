package glint.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.accel.Bvh;
import glint.accel.Intersector;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Surfaces that move while the shutter is open. */
class MotionsTest {

  private final Random random = new Random(4);

  private double in(double size) {
    return (2 * random.nextDouble() - 1) * size;
  }

  private Vector3d place(double size) {
    return new Vector3d(in(size), in(size), in(size));
  }

  private Primitives soup(boolean moving) {
    Primitives.Builder builder = new Primitives.Builder();
    for (int i = 0; i < 60; i++) {
      Vector3d at = place(4);
      Surface shape =
          switch (i % 4) {
            case 0 -> new Sphere(at, 0.5);
            case 1 -> new Triangle(at, at.plus(place(1)), at.plus(place(1)));
            case 2 -> new Box(at, at.plus(new Vector3d(0.5, 0.7, 0.4)));
            default -> new Cylinder(at, at.plus(place(1)), 0.3, 0.2, true);
          };
      boolean turned = i % 3 == 0;
      Vector3d squash = new Vector3d(1, 0.5, 0.7);
      builder.add(shape, turned ? Transform.scale(squash) : Transform.IDENTITY, i);
      Vector3d way = place(3);
      if (moving && i % 5 != 0) {
        builder.move(i, 1, way);
      }
    }
    return builder.build();
  }

  private Ray ray() {
    Ray ray = new Ray();
    Vector3d from = place(6);
    Vector3d along = place(1).normalized();
    ray.set(from.x(), from.y(), from.z(), along.x(), along.y(), along.z());
    ray.time = random.nextDouble();
    return ray;
  }

  @Test
  void theTreeFindsWhatAScanFinds() {
    Primitives soup = soup(true);
    Intersector scan = new Intersector(soup);
    Intersector walk = new Intersector(Bvh.over(soup));
    Hit one = new Hit();
    Hit other = new Hit();
    int hits = 0;
    for (int i = 0; i < 20000; i++) {
      Ray ray = ray();
      scan.closest(ray, Double.POSITIVE_INFINITY, one);
      walk.closest(ray, Double.POSITIVE_INFINITY, other);
      assertEquals(one.primitive, other.primitive);
      if (one.found()) {
        hits++;
        assertEquals(one.t, other.t);
      }
    }
    assertTrue(hits > 1000, "few hits: " + hits);
  }

  /** What leaves a surface that moves does not meet it again, at the same time. */
  @Test
  void raysLeaveWhatMoves() {
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(new Sphere(new Vector3d(1e6, 3, 5), 0.25), Transform.IDENTITY, 0);
    builder.move(0, 1, new Vector3d(1e5, 0.3, 77));
    Intersector search = new Intersector(builder.build());
    Hit hit = new Hit();
    Hit again = new Hit();
    Ray away = new Ray();
    for (int i = 0; i < 20000; i++) {
      Ray ray = new Ray();
      double time = random.nextDouble();
      Vector3d at = new Vector3d(1e6 + time * 1e5, 3 + time * 0.3, 5 + time * 77);
      Vector3d along = place(1).normalized();
      Vector3d from = at.plus(place(0.15)).minus(along.times(9));
      ray.set(from.x(), from.y(), from.z(), along.x(), along.y(), along.z());
      ray.time = time;
      search.closest(ray, Double.POSITIVE_INFINITY, hit);
      if (hit.found()) {
        search.resolve(ray, hit);
        hit.face(ray);
        Vector3d out = place(1).normalized();
        double rise = out.x() * hit.nx + out.y() * hit.ny + out.z() * hit.nz;
        Vector3d up = rise < 0 ? out.negated() : out;
        hit.spawn(up.x(), up.y(), up.z(), 1, away);
        assertEquals(time, away.time);
        assertFalse(search.any(away, Double.POSITIVE_INFINITY, again));
      }
    }
  }

  /** At time 0 everything is where it is written. */
  @Test
  void atTheBeginningNothingHasMoved() {
    random.setSeed(9);
    Intersector still = new Intersector(soup(false));
    random.setSeed(9);
    Intersector moving = new Intersector(soup(true));
    Hit one = new Hit();
    Hit other = new Hit();
    for (int i = 0; i < 5000; i++) {
      Ray ray = ray();
      ray.time = 0;
      still.closest(ray, Double.POSITIVE_INFINITY, one);
      moving.closest(ray, Double.POSITIVE_INFINITY, other);
      assertEquals(one.primitive, other.primitive);
      assertEquals(one.t, other.t);
    }
  }
}
