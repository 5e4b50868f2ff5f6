package glint.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.BadValueException;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every kind of primitive against what its formula says, near and far from the origin. */
class KernelsTest {

  private final Ray local = new Ray();

  private static Primitives of(Surface surface, Transform toWorld) {
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(surface, toWorld, 0);
    return builder.build();
  }

  private Hit closest(Primitives p, Ray ray) {
    Hit hit = new Hit();
    hit.begin(Double.POSITIVE_INFINITY);
    for (int id = 0; id < p.count(); id++) {
      p.intersect(id, ray, hit, local);
    }
    return hit;
  }

  private Hit shoot(
      Surface surface, double ox, double oy, double oz, double dx, double dy, double dz) {
    Ray ray = new Ray();
    ray.set(ox, oy, oz, dx, dy, dz);
    return closest(of(surface, Transform.IDENTITY), ray);
  }

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  /** Squares of most of these, unless scaled, are zero or infinite. */
  @Test
  void aNormalIsTheSameToTheBitForAllPowersOfTwo() {
    Random r = new Random(7);
    for (int i = 0; i < 2000; i++) {
      double x = r.nextGaussian();
      double y = Math.scalb(r.nextGaussian(), -r.nextInt(300));
      double z = Math.scalb(r.nextGaussian(), -r.nextInt(30));
      Hit hit = new Hit();
      hit.setNormal(x, y, z);
      Vector3d n = v(hit.nx, hit.ny, hit.nz);
      assertEquals(1, n.length(), 0x1p-51);
      for (int e : new int[] {-600, -525, -515, -401, -390, 1, 380, 401, 900}) {
        hit.setNormal(Math.scalb(x, e), Math.scalb(y, e), Math.scalb(z, e));
        assertEquals(n, v(hit.nx, hit.ny, hit.nz));
      }
    }
  }

  @Test
  void aTangentRayHitsAndItsNeighbourOneUlpOutDoesNot() {
    Sphere unit = new Sphere(Vector3d.ZERO, 1);
    assertEquals(10, shoot(unit, -10, 1, 0, 1, 0, 0).t);
    assertFalse(shoot(unit, -10, Math.nextUp(1.0), 0, 1, 0, 0).found());
    assertTrue(shoot(unit, -10, Math.nextDown(1.0), 0, 1, 0, 0).found());
  }

  @Test
  void pythagoreanSpheresAreHitExactly() {
    Sphere five = new Sphere(Vector3d.ZERO, 5);
    assertEquals(6, shoot(five, -10, 3, 0, 1, 0, 0).t);
    assertEquals(4, shoot(five, 0, 3, 0, 1, 0, 0).t);
    assertEquals(1, shoot(new Sphere(Vector3d.ZERO, 1), 0, 0, 0, 0, 0, 1).t);
    assertFalse(shoot(five, 10, 0, 0, 1, 0, 0).found());
  }

  @Test
  void aFarSphereIsHitWhereItIs() {
    double t = shoot(new Sphere(Vector3d.ZERO, 1), -0x1p30, 0.5, 0, 1, 0, 0).t;
    assertEquals(1073741823.1339746, t, 2 * Math.ulp(t));
  }

  @Test
  void edgesAndCornersBelongToATriangle() {
    Triangle t = new Triangle(v(0, 0, 0), v(1, 0, 0), v(0, 1, 0));
    for (double[] p : new double[][] {{0, 0}, {1, 0}, {0.5, 0.5}, {0, 0.25}}) {
      assertEquals(1, shoot(t, p[0], p[1], -1, 0, 0, 1).t);
    }
    assertFalse(shoot(t, 0.25, -0x1p-60, -1, 0, 0, 1).found());
    assertFalse(shoot(t, -1, 0.25, 0, 1, 0, 0).found(), "in its own plane");
  }

  @Test
  void aTriangleWithoutAreaIsNeverHit() {
    Triangle flat = new Triangle(v(0, 0, 0), v(1, 1, 0), v(2, 2, 0));
    assertFalse(shoot(flat, 1, 1, -1, 0, 0, 1).found());
    Triangle point = new Triangle(v(1, 1, 0), v(1, 1, 0), v(1, 1, 0));
    assertFalse(shoot(point, 1, 1, -1, 0, 0, 1).found());
  }

  @Test
  void theDiagonalOfAQuadIsClosed() {
    Quad quad = new Quad(v(0, 0, 0), v(1, 0, 0), v(0, 1, 0));
    for (int i = 0; i <= 1000; i++) {
      double s = i / 1000.0;
      assertTrue(shoot(quad, s, s, -1, 0, 0, 1).found());
      assertTrue(shoot(quad, 0.3, 0.4, 5, s - 0.3, s - 0.4, -5).found());
    }
  }

  @Test
  void aBoxIsClosedAndSeenFromInside() {
    Box box = new Box(v(-1, -2, -3), v(1, 2, 3));
    assertEquals(4, shoot(box, -5, 0, 0, 1, 0, 0).t);
    assertEquals(1, shoot(box, 0, 0, 0, 1, 0, 0).t);
    assertEquals(4, shoot(box, -5, 2, 3, 1, 0, 0).t, "along an edge");
    assertEquals(4, shoot(box, -5, 2, 3, 1, -0.0, 0.0).t);
    assertFalse(shoot(box, -5, Math.nextUp(2.0), 0, 1, 0, 0).found());
    assertFalse(shoot(box, 5, 0, 0, 1, 0, 0).found());
  }

  @Test
  void cylindersConesAndTheirCapsAreHitWhereTheyAre() {
    Cylinder capped = new Cylinder(v(0, 0, 0), v(0, 2, 0), 1, 1, true);
    assertEquals(4, shoot(capped, -5, 1, 0, 1, 0, 0).t);
    assertEquals(3, shoot(capped, 0.5, 5, 0, 0, -1, 0).t);
    assertEquals(2, shoot(capped, 0.5, -2, 0, 0, 1, 0).t);
    assertEquals(1, shoot(capped, 0, 1, 0, 1, 0, 0).t);
    assertEquals(4, shoot(capped, -5, 2, 0, 1, 0, 0).t, "along the rim");
    assertFalse(shoot(capped, -5, 2.0000001, 0, 1, 0, 0).found());
    Cylinder open = new Cylinder(v(0, 0, 0), v(0, 2, 0), 1, 1, false);
    assertFalse(shoot(open, 0.5, 5, 0, 0, -1, 0).found());
    assertEquals(2, shoot(open, 0, 3, 0, 1, -1, 0).t + 1, 1e-15);
    Cylinder cone = new Cylinder(v(0, 0, 0), v(0, 2, 0), 1, 0, true);
    assertEquals(4.5, shoot(cone, -5, 1, 0, 1, 0, 0).t, 1e-15);
    assertEquals(3, shoot(cone, 0, 5, 0, 0, -1, 0).t, 1e-15);
    assertEquals(4, shoot(cone, 0.5, 5, 0, 0, -1, 0).t, 1e-15);
    assertFalse(shoot(cone, -5, 3, 0, 1, 0, 0).found(), "no second nappe");
  }

  @Test
  void anEllipsoidIsASphereThroughATransform() {
    Primitives p = of(new Sphere(Vector3d.ZERO, 1), Transform.scale(v(2, 1, 0.5)));
    Ray ray = new Ray();
    ray.set(-10, 0, 0, 1, 0, 0);
    assertEquals(8, closest(p, ray).t);
    ray.set(0, 0, 10, 0, 0, -4);
    assertEquals(9.5 / 4, closest(p, ray).t);
    ray.set(1, 0.5, 5, 0, 0, -1);
    Hit hit = closest(p, ray);
    p.resolve(ray, hit, local);
    Vector3d gradient = v(1 / 4.0, 0.5, hit.pz / 0.25).normalized();
    assertEquals(gradient.x(), hit.nx, 1e-14);
    assertEquals(gradient.y(), hit.ny, 1e-14);
    assertEquals(gradient.z(), hit.nz, 1e-14);
  }

  /** Whoever asks again and again for what comes next gets to an end, even among subnormals. */
  @Test
  void aTransformedBoxIsMetTwiceHoweverNearItIs() {
    Random r = new Random(9);
    Box box = new Box(v(-1e-300, -1e-300, -1e-300), v(0, 1e-300, 1e-300));
    Ray ray = new Ray();
    for (int i = 0; i < 1000; i++) {
      double factor = Math.scalb(1 + r.nextDouble(), -28);
      Transform small = Transform.scale(v(factor, factor, factor));
      Quaternion turn = Quaternion.aboutAxis(v(r.nextDouble(), 1, 1), 30 * r.nextDouble());
      Primitives one = of(box, small.then(Transform.rotate(turn)));
      Vector3d o = turn(turn, v(-1e-308, 0, 0)).plus(v(-1e-309 * r.nextDouble(), 0, 0));
      ray.set(o.x(), o.y(), o.z(), 1, r.nextDouble(), r.nextDouble());
      int met = 0;
      for (Hit hit = closest(one, ray); hit.found() && met < 3; hit = closest(one, ray)) {
        ray.goOnAfter(hit);
        met++;
      }
      assertTrue(met < 3);
    }
  }

  private static Vector3d turn(Quaternion q, Vector3d v) {
    return Transform.rotate(q).direction(v);
  }

  @Test
  void aMeshKeepsItsOutsideUnderAMirroringTransform() {
    Mesh mesh = new Mesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
    Ray ray = new Ray();
    ray.set(0.25, 0.25, 5, 0, 0, -1);
    Primitives plain = of(mesh, Transform.IDENTITY);
    Hit hit = closest(plain, ray);
    plain.resolve(ray, hit, local);
    assertEquals(1, hit.nz);
    Primitives mirrored = of(mesh, Transform.scale(v(-1, 1, 1)));
    ray.set(-0.25, 0.25, 5, 0, 0, -1);
    hit = closest(mirrored, ray);
    mirrored.resolve(ray, hit, local);
    assertEquals(1, hit.nz);
  }

  @Test
  void aMeshWithACornerThatIsNoPointIsRefused() {
    double[] point = {0, 0, 0};
    assertThrows(BadValueException.class, () -> new Mesh(point, new int[] {0, 0, 1}));
    assertThrows(BadValueException.class, () -> new Mesh(point, new int[] {0, -1, 0}));
    double[] broken = {0, Double.NaN, 0};
    assertThrows(BadValueException.class, () -> new Mesh(broken, new int[] {0, 0, 0}));
  }

  static List<Transform> places() {
    Transform turned = Transform.rotate(Quaternion.aboutAxis(v(1, 2, 3), 40));
    return List.of(
        Transform.IDENTITY,
        turned,
        turned.then(Transform.translate(v(1e6, -2e6, 3e6))),
        Transform.scale(v(1e-3, 1e-3, 1e-3)).then(turned),
        Transform.scale(v(3, 0.5, 1)).then(turned),
        Transform.scale(v(1e3, 2, 1e-2)).then(turned).then(Transform.translate(v(1e5, 0, 0))),
        turned.then(Transform.scale(v(1e6, 1e6, 1e6))).then(Transform.translate(v(0, 1e9, 0))));
  }

  private static List<Surface> convex() {
    return List.of(
        new Sphere(v(0.2, -0.1, 0.3), 1.5),
        new Box(v(-1, -0.7, -0.6), v(0.9, 1, 1.2)),
        new Cylinder(v(0, -1, 0.1), v(0.3, 1, 0), 0.8, 0.8, true),
        new Cylinder(v(0, -1, 0), v(0.3, 1.5, 0), 1, 0, true),
        new Cylinder(v(0, -1, 0), v(0, 1, 0.2), 0.6, 1.1, true),
        new Pyramid(v(0, 1.5, 0), List.of(v(-1, -1, -1), v(1, -1, -1), v(1, -1, 1), v(-1, -1, 1))),
        new Plane(v(0.1, 0.2, 0.3), v(1, 2, 3)),
        new Triangle(v(-2, -2, 0), v(2, -1, 0.3), v(0, 2, -0.4)),
        new Quad(v(-1, -1, 0), v(2, 0.1, 0), v(0, 2, 0.3)));
  }

  /** Rays that leave a convex surface, half of them grazing, never meet it again. */
  @ParameterizedTest
  @MethodSource("places")
  void noSurfaceShadowsItself(Transform place) {
    Random random = new Random(7);
    for (Surface surface : convex()) {
      Primitives p = of(surface, place);
      int tried = 0;
      for (int i = 0; i < 4000; i++) {
        Ray ray = new Ray();
        Vector3d from = place.point(around(random, 6));
        Vector3d to = place.point(around(random, 0.7));
        ray.set(
            from.x(), from.y(), from.z(), to.x() - from.x(), to.y() - from.y(), to.z() - from.z());
        Hit hit = closest(p, ray);
        if (!hit.found()) {
          continue;
        }
        p.resolve(ray, hit, local);
        // Turn the normal to the viewer's side and leave on that side.
        double side = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz > 0 ? -1 : 1;
        if (side < 0 && closed(surface)) {
          continue;
        }
        Vector3d n = v(side * hit.nx, side * hit.ny, side * hit.nz);
        Vector3d along = n.cross(around(random, 1)).normalized();
        double steep = i % 2 == 0 ? random.nextDouble() : 1e-6 * random.nextDouble();
        Vector3d d = along.plus(n.times(steep + 1e-9));
        Ray leaving = new Ray();
        hit.spawn(d.x(), d.y(), d.z(), leaving);
        assertFalse(closest(p, leaving).found(), () -> surface + " is hit again by its own ray");
        tried++;
      }
      assertTrue(tried > 1000, "too few hits of " + surface + ": " + tried);
    }
  }

  /** What a ray leaves outward is not tried; from inside, it is met on its far side. */
  @Test
  void onlyWhatIsLeftOutwardIsLeftOut() {
    Primitives p = of(new Sphere(v(0, 0, 0), 1), Transform.IDENTITY);
    Ray ray = new Ray();
    ray.set(-3, 0.5, 0, 1, 0, 0);
    Hit outside = closest(p, ray);
    p.resolve(ray, outside, local);
    outside.face(ray);
    Ray next = new Ray();
    outside.spawn(-1, 0, 0, 1, next);
    assertEquals(outside.primitive, next.left);
    outside.spawnTo(-3, 3, 0, next);
    assertEquals(outside.primitive, next.left);
    outside.spawnToLight(1, 0, 0, next); // into it
    assertTrue(closest(p, next).found());
    outside.spawn(1, 0, 0, -1, next); // bent
    Hit inside = closest(p, next);
    assertTrue(inside.found());
    p.resolve(next, inside, local);
    inside.face(next);
    inside.spawn(-0.6, 0.8, 0, 1, ray); // mirrored within
    assertTrue(closest(p, ray).found());
    inside.spawn(1, 0, 0, -1, ray); // bent outward
    assertEquals(inside.primitive, ray.left);
    Ray copy = new Ray();
    copy.copy(ray); // perhaps for other primitives
    assertEquals(Hit.NONE, copy.left);
    inside.copyPart(outside); // of another primitive there
    inside.spawn(1, 0, 0, -1, ray);
    assertEquals(Hit.NONE, ray.left);
  }

  private static boolean closed(Surface s) {
    return !(s instanceof Plane || s instanceof Triangle || s instanceof Quad);
  }

  private static Vector3d around(Random random, double radius) {
    return v(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
        .normalized()
        .times(radius);
  }
}
