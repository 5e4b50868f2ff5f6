package glint.geometry;

import glint.math.Transform;
import glint.math.Vector3d;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The surfaces of a scene in the form that rays touch: flat arrays of primitives in world space.
 *
 * <p>A primitive is one thing that a kernel can hit. Quads and pyramids become triangles; what a
 * transform leaves in its own kind (a sphere that stays round) moves into the world, anything else
 * keeps its object space and moves the ray. Numbers of primitives follow scene order, which settles
 * equal distances.
 */
public final class Primitives {

  private static final byte SPHERE = 0;
  private static final byte TRIANGLE = 1;
  private static final byte PLANE = 2;
  private static final byte BOX = 3;
  private static final byte CYLINDER = 4;

  /** A triangle whose outside is where its corners run clockwise. */
  private static final byte REVERSED_TRIANGLE = 5;

  /** Added to a kind: the data begins with two matrices (see TransformedKernel). */
  private static final byte TRANSFORMED = 8;

  private final byte[] kind;
  private final int[] start;
  private final int[] surface;
  private final double[] data;

  private Primitives(Builder b) {
    kind = Arrays.copyOf(b.kind, b.count);
    start = Arrays.copyOf(b.start, b.count);
    surface = Arrays.copyOf(b.surface, b.count);
    data = Arrays.copyOf(b.data, b.used);
  }

  /** Returns the number of primitives. */
  public int count() {
    return kind.length;
  }

  /**
   * Offers the hit of a ray with one primitive to a search.
   *
   * @param local scratch for the ray in object space
   */
  public void intersect(int id, Ray ray, Hit hit, Ray local) {
    int at = start[id];
    int k = kind[id];
    if (k >= TRANSFORMED) {
      TransformedKernel.toObject(data, at, ray, local);
      intersect(k - TRANSFORMED, at + TransformedKernel.SIZE, local, hit, id);
    } else {
      intersect(k, at, ray, hit, id);
    }
  }

  private void intersect(int k, int at, Ray ray, Hit hit, int id) {
    switch (k) {
      case SPHERE -> SphereKernel.intersect(data, at, ray, hit, id);
      case TRIANGLE, REVERSED_TRIANGLE -> TriangleKernel.intersect(data, at, ray, hit, id);
      case PLANE -> PlaneKernel.intersect(data, at, ray, hit, id);
      case BOX -> BoxKernel.intersect(data, at, ray, hit, id);
      default -> CylinderKernel.intersect(data, at, ray, hit, id);
    }
  }

  /** Fills in point, normal, surface and offset of a hit that was found with this ray. */
  public void resolve(Ray ray, Hit hit, Ray local) {
    int id = hit.primitive;
    int at = start[id];
    int k = kind[id];
    hit.surface = surface[id];
    if (k >= TRANSFORMED) {
      TransformedKernel.toObject(data, at, ray, local);
      resolve(k - TRANSFORMED, at + TransformedKernel.SIZE, local, hit);
      TransformedKernel.toWorld(data, at, hit);
    } else {
      resolve(k, at, ray, hit);
    }
  }

  private void resolve(int k, int at, Ray ray, Hit hit) {
    switch (k) {
      case SPHERE -> SphereKernel.resolve(data, at, ray, hit);
      case TRIANGLE -> TriangleKernel.resolve(data, at, hit);
      case REVERSED_TRIANGLE -> {
        TriangleKernel.resolve(data, at, hit);
        hit.reverse();
      }
      case PLANE -> PlaneKernel.resolve(data, at, ray, hit);
      case BOX -> BoxKernel.resolve(data, at, ray, hit);
      default -> CylinderKernel.resolve(data, at, ray, hit);
    }
  }

  /** Collects surfaces in scene order. */
  public static final class Builder {

    private byte[] kind = new byte[16];
    private int[] start = new int[16];
    private int[] surface = new int[16];
    private double[] data = new double[256];
    private int count;
    private int used;

    /** Adds a surface, carried into the world by {@code toWorld}, under a surface number. */
    public void add(Surface shape, Transform toWorld, int number) {
      if (shape instanceof Sphere s) {
        addSphere(s, toWorld, number);
      } else if (shape instanceof Triangle t) {
        addFlat(List.of(t.a(), t.b(), t.c()), toWorld, number);
      } else if (shape instanceof Plane p) {
        Vector3d normal = toWorld.normal(p.normal());
        put(PLANE, PlaneKernel.pack(toWorld.point(p.point()), normal), number);
      } else if (shape instanceof Quad q) {
        Vector3d b = q.corner().plus(q.edge1());
        Vector3d d = q.corner().plus(q.edge2());
        addFlat(List.of(q.corner(), b, b.plus(q.edge2()), d), toWorld, number);
      } else if (shape instanceof Box b) {
        addBox(b, toWorld, number);
      } else if (shape instanceof Pyramid p) {
        addPyramid(p, toWorld, number);
      } else if (shape instanceof Cylinder c) {
        addCylinder(c, toWorld, number);
      }
    }

    /** Returns the primitives added so far. */
    public Primitives build() {
      return new Primitives(this);
    }

    private void addSphere(Sphere s, Transform toWorld, int number) {
      double scale = toWorld.uniformScale();
      if (scale > 0) {
        Vector3d center = toWorld.point(s.center());
        put(SPHERE, SphereKernel.pack(center, scale * s.radius()), number);
      } else {
        putTransformed(SPHERE, toWorld, SphereKernel.pack(s.center(), s.radius()), number);
      }
    }

    private void addBox(Box b, Transform toWorld, int number) {
      if (toWorld.isIdentity()) {
        put(BOX, BoxKernel.pack(b.min(), b.max()), number);
      } else {
        putTransformed(BOX, toWorld, BoxKernel.pack(b.min(), b.max()), number);
      }
    }

    private void addCylinder(Cylinder c, Transform toWorld, int number) {
      double scale = toWorld.uniformScale();
      if (scale > 0) {
        Vector3d base = toWorld.point(c.base());
        Vector3d top = toWorld.point(c.top());
        double r = scale * c.radius();
        double topR = scale * c.topRadius();
        put(CYLINDER, CylinderKernel.pack(base, top, r, topR, c.capped()), number);
      } else {
        double[] own =
            CylinderKernel.pack(c.base(), c.top(), c.radius(), c.topRadius(), c.capped());
        putTransformed(CYLINDER, toWorld, own, number);
      }
    }

    private void addFlat(List<Vector3d> corners, Transform toWorld, int number) {
      addPolygon(
          corners.stream().map(toWorld::point).collect(Collectors.toList()), TRIANGLE, number);
    }

    /** Adds base and sides, reversed where their winding makes a normal point into the solid. */
    private void addPyramid(Pyramid p, Transform toWorld, int number) {
      Vector3d apex = toWorld.point(p.apex());
      List<Vector3d> base = p.base().stream().map(toWorld::point).collect(Collectors.toList());
      Vector3d normal = base.get(1).minus(base.get(0)).cross(base.get(2).minus(base.get(0)));
      boolean inward = normal.dot(apex.minus(base.get(0))) > 0;
      addPolygon(base, inward ? REVERSED_TRIANGLE : TRIANGLE, number);
      for (int i = 0; i < 4; i++) {
        List<Vector3d> side = List.of(apex, base.get((i + 1) % 4), base.get(i));
        addPolygon(side, inward ? REVERSED_TRIANGLE : TRIANGLE, number);
      }
    }

    /** Fans a convex polygon in world space into triangles around its first corner. */
    private void addPolygon(List<Vector3d> corners, byte k, int number) {
      for (int i = 2; i < corners.size(); i++) {
        double[] three = TriangleKernel.pack(corners.get(0), corners.get(i - 1), corners.get(i));
        put(k, three, number);
      }
    }

    private void putTransformed(byte k, Transform toWorld, double[] own, int number) {
      put((byte) (k + TRANSFORMED), TransformedKernel.pack(toWorld, own), number);
    }

    private void put(byte k, double[] numbers, int number) {
      if (count == kind.length) {
        kind = Arrays.copyOf(kind, 2 * count);
        start = Arrays.copyOf(start, 2 * count);
        surface = Arrays.copyOf(surface, 2 * count);
      }
      while (used + numbers.length > data.length) {
        data = Arrays.copyOf(data, 2 * data.length);
      }
      kind[count] = k;
      start[count] = used;
      surface[count] = number;
      System.arraycopy(numbers, 0, data, used, numbers.length);
      used += numbers.length;
      count++;
    }
  }
}
