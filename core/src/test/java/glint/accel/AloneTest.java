package glint.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Primitives;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a search says of the way beyond its hit is what a search of that way finds. */
class AloneTest {

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Vector3d random(Random r, double scale) {
    return v(r.nextGaussian() * scale, r.nextGaussian() * scale, r.nextGaussian() * scale);
  }

  /**
   * Surfaces of every kind, each at two places at most a few roundings apart, or one in the other.
   */
  private static Primitives pairs(Random r, int count) {
    Primitives.Builder builder = new Primitives.Builder();
    double[] corners = {-1, -1, 0, 1, -1, 0, 0, 1, 0.5, 0, -1, 1};
    Mesh mesh = new Mesh(corners, new int[] {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 2, 3});
    for (int i = 0; i < count; i++) {
      int kind = r.nextInt(7);
      Transform turn = Transform.rotate(Quaternion.aboutAxis(random(r, 1), 360 * r.nextDouble()));
      Vector3d at = random(r, 2);
      for (int twice = 0; twice < 2; twice++) {
        double size = r.nextInt(3) == 0 ? 0.9 : 1 + r.nextInt(3) * 0x1p-51;
        Transform put =
            Transform.scale(v(size, size, size)).then(turn).then(Transform.translate(at));
        int surface = 2 * i + twice;
        if (kind == 6) {
          builder.show(mesh, put, surface, false);
        } else {
          builder.add(shape(kind), kind < 3 ? put : Transform.translate(at), surface);
        }
        if (i % 5 == 0) {
          builder.move(surface, 1, v(0.5, 0, 0));
        }
      }
    }
    return builder.build();
  }

  private static Surface shape(int kind) {
    return switch (kind) {
      case 0 -> new Sphere(Vector3d.ZERO, 1);
      case 1 -> new Box(v(-1, -1, -1), v(1, 0.5, 1));
      case 2 -> new Cylinder(Vector3d.ZERO, v(0, 1, 0), 1, 0.3, true);
      case 3 -> new Triangle(v(-1, 0, 0), v(1, 0.3, 0), v(0, 1, 1));
      case 4 -> new Plane(Vector3d.ZERO, v(1, 2, 3));
      default -> new Cylinder(Vector3d.ZERO, v(0.2, 1, 0), 0.5, 1, false);
    };
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 4, 20, 100})
  void nothingIsMetWhereAHitIsAlone(int count) {
    Random r = new Random(count);
    int alone = 0;
    int met = 0;
    for (int world = 0; world < 100; world++) {
      Primitives pairs = pairs(r, count);
      boolean few = count < 5 && pairs.models().isEmpty();
      Intersector search =
          few ? new Intersector(Boxes.around(pairs)) : new Intersector(Bvh.over(pairs));
      Intersector all = new Intersector(pairs);
      Ray ray = new Ray();
      Hit hit = new Hit();
      Hit other = new Hit();
      for (int i = 0; i < 200; i++) {
        Vector3d o = random(r, 3);
        Vector3d d = random(r, 2).minus(o);
        ray.set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
        ray.time = r.nextDouble();
        search.closest(ray, Double.POSITIVE_INFINITY, hit);
        if (!hit.found()) {
          continue;
        }
        ray.goOnAfter(hit);
        for (double end = hit.t; end <= 2 * hit.t; end *= 1 + StrictMath.pow(2, -r.nextInt(53))) {
          boolean isAlone = search.isAlone(hit, end);
          all.closest(ray, end, other);
          assertFalse(isAlone && other.found());
          alone += isAlone ? 1 : 0;
          met += other.found() ? 1 : 0;
        }
      }
    }
    assertTrue(alone > 500, "alone: " + alone);
    assertTrue(met > 500, "met: " + met);
  }

  /** A ray that enters a ball of diameter 2 at t = 3 leaves it at t = 5. */
  @Test
  void theOtherSideOfASolidEndsIt() {
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(new Sphere(v(4, 0, 0), 1), Transform.IDENTITY, 0);
    Intersector search = new Intersector(Boxes.around(builder.build()));
    Ray ray = new Ray();
    Hit hit = new Hit();
    ray.set(0, 0, 0, 1, 0, 0);
    search.closest(ray, 10, hit);
    assertEquals(3, hit.t);
    assertEquals(5, hit.next);
    assertTrue(search.isAlone(hit, Math.nextUp(3.0)));
    assertFalse(search.isAlone(hit, 5));
  }
}
