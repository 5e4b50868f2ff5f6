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
import glint.geometry.Quad;
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

/** A tree, and boxes without one, find what a scan of everything finds, bit for bit. */
class BvhTest {

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Vector3d random(Random r, double scale) {
    return v(r.nextGaussian() * scale, r.nextGaussian() * scale, r.nextGaussian() * scale);
  }

  /** Surfaces of every kind, their sizes spread over twelve orders of magnitude. */
  private static Primitives soup(Random r, int count, double spread) {
    Primitives.Builder builder = new Primitives.Builder();
    for (int i = 0; i < count; i++) {
      double size = StrictMath.pow(10, -6 * r.nextDouble() * spread);
      Vector3d at = random(r, 1);
      Transform turn =
          Transform.scale(v(1, 0.2 + r.nextDouble(), 1))
              .then(Transform.rotate(Quaternion.aboutAxis(random(r, 1), 360 * r.nextDouble())))
              .then(Transform.translate(at));
      builder.add(shape(r, i, size), i % 3 == 0 ? turn : Transform.translate(at), i);
    }
    return builder.build();
  }

  private static Surface shape(Random r, int i, double size) {
    return switch (i % 7) {
      case 0, 1 -> new Sphere(Vector3d.ZERO, size);
      case 2 -> new Box(v(-size, -size, -size), v(size, 0.5 * size, size));
      case 3 -> new Cylinder(Vector3d.ZERO, random(r, size), size, 0.3 * size, i % 2 == 0);
      case 4 -> new Quad(Vector3d.ZERO, v(size, 0, 0), v(0, 0, size));
      case 5 ->
          i % 5 == 0 ? new Plane(random(r, 9), random(r, 1)) : new Sphere(Vector3d.ZERO, size);
      default -> new Triangle(random(r, size), random(r, size), random(r, size));
    };
  }

  private static void assertSame(Primitives primitives, Random r, int rays, double distance) {
    Intersector tree = new Intersector(Bvh.over(primitives));
    assertSame(primitives, tree, r, rays, distance);
    if (primitives.count() < 200) {
      assertSame(primitives, new Intersector(Boxes.around(primitives)), r, rays, distance);
    }
  }

  private static void assertSame(
      Primitives primitives, Intersector fast, Random r, int rays, double distance) {
    Intersector scan = new Intersector(primitives);
    Ray ray = new Ray();
    Hit a = new Hit();
    Hit b = new Hit();
    int found = 0;
    for (int i = 0; i < rays; i++) {
      Vector3d o = random(r, distance);
      Vector3d d = random(r, 1).minus(o);
      // Every third ray runs along an axis, with zeros of both signs.
      switch (i % 9) {
        case 0 -> d = v(0.0, -0.0, d.z());
        case 3 -> d = v(-0.0, d.y(), 0.0);
        case 6 -> d = v(d.x(), 0.0, 0.0);
        default -> {}
      }
      ray.set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
      fast.closest(ray, Double.POSITIVE_INFINITY, a);
      scan.closest(ray, Double.POSITIVE_INFINITY, b);
      assertEquals(b.primitive, a.primitive);
      assertEquals(b.t, a.t);
      if (b.found()) {
        found++;
        fast.resolve(ray, a);
        scan.resolve(ray, b);
        assertEquals(b.surface, a.surface);
        assertEquals(b.px, a.px);
        double t = b.t;
        assertTrue(fast.any(ray, t, a));
        assertFalse(fast.any(ray, Math.nextDown(t), a));
        assertEquals(scan.any(ray, 0.7 * t, b), fast.any(ray, 0.7 * t, a));
      }
    }
    assertTrue(found > rays / 50, "too few hits: " + found);
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 3, 5, 9, 100, 1000, 3000})
  void soupsOfMixedScale(int count) {
    Random r = new Random(count);
    Primitives soup = soup(r, count, count < 20 ? 0.05 : 0.5);
    assertSame(soup, r, 10_000, 3);
    assertSame(soup, r, 2_000, 1e6);
  }

  /** Worlds of one kind, of two that take as many numbers, and of two that don't, behind planes. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6})
  void surfacesThatAreAlike(int kind) {
    Random r = new Random(kind);
    Primitives.Builder builder = new Primitives.Builder();
    Transform mirrored = Transform.scale(v(-1, 1, 1));
    Transform flattened = Transform.scale(v(1, 0.4, 1));
    for (int i = 0; i < 60; i++) {
      Surface triangle = new Triangle(random(r, 1), random(r, 1), random(r, 1));
      Surface sphere = new Sphere(random(r, 1), 0.2);
      Transform to = Transform.IDENTITY;
      Surface shape = sphere;
      switch (kind) {
        case 0 -> {}
        case 1 -> shape = triangle;
        case 2 -> {
          double[] points = r.doubles(9, -1, 1).toArray();
          shape = new Mesh(points, new int[] {0, 1, 2});
          to = i % 2 == 0 ? Transform.IDENTITY : mirrored;
        }
        case 3 -> to = flattened;
        case 4 -> shape = i % 2 == 0 ? sphere : triangle;
        case 5 -> to = i % 2 == 0 ? Transform.IDENTITY : flattened;
        default -> shape = i % 20 == 3 ? new Plane(random(r, 9), random(r, 1)) : triangle;
      }
      builder.add(shape, to, i);
    }
    assertSame(builder.build(), r, 2_000, 3);
  }

  @Test
  void tinySpheresBesideAHugeOne() {
    Random r = new Random(1);
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(new Sphere(v(0, -1e9, 0), 1e9), Transform.IDENTITY, 0);
    for (int i = 1; i < 300; i++) {
      builder.add(new Sphere(random(r, 1e-3), 1e-6), Transform.IDENTITY, i);
    }
    assertSame(builder.build(), r, 5_000, 2);
  }

  @Test
  void coincidentPrimitivesEndTheBuildAndTheLowestNumberWins() {
    Primitives.Builder builder = new Primitives.Builder();
    for (int i = 0; i < 10_000; i++) {
      builder.add(new Sphere(v(1, 2, 3), 1), Transform.IDENTITY, i);
    }
    Intersector fast = new Intersector(Bvh.over(builder.build()));
    Ray ray = new Ray();
    Hit hit = new Hit();
    for (int i = 0; i < 100; i++) {
      ray.set(-5, 2 + 0.01 * i - 0.5, 3, 1, 0, 0);
      fast.closest(ray, Double.POSITIVE_INFINITY, hit);
      assertEquals(0, hit.primitive);
    }
  }

  @Test
  void theDepthIsBoundedForGeometricRows() {
    Primitives.Builder builder = new Primitives.Builder();
    for (int i = 0; i < 2000; i++) {
      double x = Math.scalb(1.0, i / 10 - 100);
      builder.add(new Sphere(v(x, 0, 0), x / 64), Transform.IDENTITY, i);
    }
    Bvh tree = Bvh.over(builder.build());
    assertTrue(tree.depth() <= Bvh.MAX_DEPTH);
    assertSame(tree.primitives(), new Random(3), 1000, 1e20);
  }

  @Test
  void everyBoxHoldsWhatIsBelowItWithAMargin() {
    for (double spread : new double[] {0.01, 0.5, 1}) {
      Bvh tree = Bvh.over(soup(new Random(5), 5000, spread));
      // Half of what boxes are widened by: computing a wider box in doubles has rounded, too.
      assertTrue(tree.tightestMargin() >= tree.size() * Boxes.MARGIN / 2);
    }
  }

  @Test
  void nothingAndOneThingAreFound() {
    Ray ray = new Ray();
    ray.set(0, 0, -5, 0, 0, 1);
    Hit hit = new Hit();
    new Intersector(Bvh.over(new Primitives.Builder().build()))
        .closest(ray, Double.POSITIVE_INFINITY, hit);
    assertFalse(hit.found());
    Primitives.Builder one = new Primitives.Builder();
    one.add(new Sphere(Vector3d.ZERO, 1), Transform.IDENTITY, 0);
    new Intersector(Bvh.over(one.build())).closest(ray, Double.POSITIVE_INFINITY, hit);
    assertEquals(4, hit.t);
  }

  @Test
  void raysThatAreNotFiniteVisitOneNode() {
    Intersector fast = new Intersector(Bvh.over(soup(new Random(2), 500, 0.1)));
    Hit hit = new Hit();
    Ray ray = new Ray();
    double[] bad = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (int i = 0; i < 6; i++) {
      for (double v : bad) {
        double[] six = {0.1, 0.2, -9, 0.01, 0.02, 1};
        six[i] = v;
        ray.set(six[0], six[1], six[2], six[3], six[4], six[5]);
        long before = fast.nodesVisited();
        fast.closest(ray, Double.POSITIVE_INFINITY, hit);
        assertEquals(1, fast.nodesVisited() - before);
        assertFalse(hit.found());
      }
    }
  }
}
