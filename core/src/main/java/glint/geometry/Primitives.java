package glint.geometry;

import glint.math.Transform;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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

  private static final int SPHERE = 0;
  private static final int TRIANGLE = 1;
  private static final int PLANE = 2;
  private static final int BOX = 3;
  private static final int CYLINDER = 4;

  /** A triangle whose outside is where its corners run clockwise. */
  private static final int REVERSED_TRIANGLE = 5;

  /** A model at a place; in place of a start in the data, the number of the place. */
  private static final int INSTANCE = 6;

  /** The same, but each part of the model is a surface of its own. */
  private static final int INSTANCE_IN_PARTS = 7;

  /** Added to a kind: the data begins with two matrices (see TransformedKernel). */
  private static final int TRANSFORMED = 8;

  private static final int START_SHIFT = 4;
  private static final int NUMBER_SHIFT = 33;

  /** The most doubles that all primitives together can take: 59 million triangles. */
  private static final int MAX_DOUBLES = (1 << NUMBER_SHIFT - START_SHIFT) - 1;

  /** Kind, place in the data and number of each primitive, packed: one look into memory. */
  private final long[] head;

  private final int[] surface;
  private final double[] data;

  /** For meshes that are not instances, by surface, the number of its first primitive. */
  private final int[] firstNumber;

  private final Instances instances;

  /** How surfaces move, or null where all stand still. */
  private final Motions motions;

  private final int unbounded;
  private final double conditioning;
  private final int degenerate;

  /** The kind of kernel that all bounded primitives have in common, or -1. */
  private final int commonKind;

  /** Where the data of the bounded primitives begin, and how many each takes if they are alike. */
  private final int firstBounded;

  private final int commonSize;

  private Primitives(Builder b, int unbounded) {
    head = Arrays.copyOf(b.head, b.count);
    surface = Arrays.copyOf(b.surface, b.count);
    data = Arrays.copyOf(b.data, b.used);
    firstNumber = b.firstNumber;
    motions = b.ways.length > 0 ? new Motions(b.ways) : null;
    instances = b.instances();
    this.unbounded = unbounded;
    conditioning = b.conditioning;
    degenerate = b.degenerate;
    commonKind = findCommonKind();
    firstBounded = unbounded < head.length ? start(head[unbounded]) : 0;
    commonSize = commonKind < 0 ? 0 : sizeOf(commonKind);
  }

  private int findCommonKind() {
    if (motions != null) {
      return -1;
    }
    int common = -1;
    for (int slot = unbounded; slot < head.length; slot++) {
      int k = kind(head[slot]) == REVERSED_TRIANGLE ? TRIANGLE : kind(head[slot]);
      if (k >= TRANSFORMED || isInstance(slot) || (common >= 0 && k != common)) {
        return -1;
      }
      common = k;
    }
    return common;
  }

  /** Returns the number of primitives. */
  public int count() {
    return head.length;
  }

  /** Returns the number of the surface that the primitive in a slot is part of. */
  public int surface(int slot) {
    return surface[slot];
  }

  /** Returns which triangle of its mesh was hit. */
  public int triangle(Hit hit) {
    return isInstance(hit.slot) ? hit.part : hit.primitive - firstNumber[hit.surface];
  }

  /** Returns what the arrays take in memory. */
  public long bytes() {
    long own = 8L * head.length + 4L * (surface.length + firstNumber.length) + 8L * data.length;
    return own + instances.bytes();
  }

  /** Returns the meshes in their own space that instances show. */
  public List<Primitives> models() {
    return instances.models();
  }

  /** Returns whether the primitive in a slot is a model at a place: not for a kernel to hit. */
  public boolean isInstance(int slot) {
    int k = kind(head[slot]);
    return k == INSTANCE || k == INSTANCE_IN_PARTS;
  }

  /** Returns the number of the model that the instance in a slot shows. */
  public int model(int slot) {
    return instances.model(start(head[slot]));
  }

  /** Sets {@code inModel} to a ray as the model of the instance in a slot sees it. */
  public void toModel(int slot, Ray ray, Hit hit, Ray inModel) {
    instances.toModel(start(head[slot]), number(head[slot]), ray, inModel, hit.numbers);
  }

  /** Offers what was found within the model of the instance in a slot to a search. */
  public void offer(int slot, Hit inModel, Hit hit) {
    int id = number(head[slot]);
    boolean nearer = inModel.t < hit.t || (inModel.t == hit.t && id < hit.primitive);
    if (inModel.found() && nearer) {
      hit.t = inModel.t;
      hit.primitive = id;
      hit.slot = slot;
      hit.part = inModel.primitive;
      hit.partSlot = inModel.slot;
      hit.crossing = inModel.crossing;
      hit.u = inModel.u;
      hit.v = inModel.v;
    }
    hit.passBy(inModel.next); // where the model is met, at most where its search was to end
  }

  /** Returns how many primitives have no bounds; they take the first slots. */
  public int unbounded() {
    return unbounded;
  }

  /** Returns how many triangles were left out because they have no area. */
  public int degenerate() {
    return degenerate;
  }

  /**
   * Returns by how much transforms may magnify rounding: the largest |M||M⁻¹| of any, at least 1.
   */
  public double conditioning() {
    return conditioning;
  }

  /**
   * Returns the same primitives with the bounded ones in another order, and data in that order.
   *
   * @param models the same models, in orders of their own
   */
  public Primitives reordered(int[] order, List<Primitives> models) {
    Builder b = new Builder(this);
    b.instances = instances.showing(models);
    for (int slot = 0; slot < head.length; slot++) {
      int from = slot < unbounded ? slot : unbounded + order[slot - unbounded];
      b.put(kind(head[from]), data, start(head[from]), number(head[from]), surface[from]);
    }
    return new Primitives(b, unbounded);
  }

  /**
   * Offers the hit of a ray with the primitive in a slot to a search.
   *
   * @param local scratch for the ray in object space
   */
  public void intersect(int slot, Ray ray, Hit hit, Ray local) {
    boolean moves = motions != null && motions.moves(surface[slot]);
    meet(slot, moves ? motions.still(surface[slot], ray) : ray, hit, local);
  }

  private void meet(int slot, Ray ray, Hit hit, Ray local) {
    long h = head[slot];
    int at = start(h);
    int k = kind(h);
    int id = number(h);
    if (id == ray.left) {
      return;
    }
    if (k >= TRANSFORMED) {
      TransformedKernel.toObject(data, at, ray, local);
      intersect(k - TRANSFORMED, at + TransformedKernel.SIZE, local, hit, id);
    } else {
      intersect(k, at, ray, hit, id);
    }
    if (hit.primitive == id) {
      hit.slot = slot;
    }
  }

  /**
   * Does the same for a bounded primitive, and where all of these are alike without a look at the
   * head first, which in a large scene would be two waits for memory in a row.
   */
  public void intersectBounded(int slot, Ray ray, Hit hit, Ray local) {
    if (commonKind < 0) {
      intersect(slot, ray, hit, local);
      return;
    }
    int id = number(head[slot]);
    if (id != ray.left) {
      intersect(commonKind, firstBounded + (slot - unbounded) * commonSize, ray, hit, id);
      if (hit.primitive == id) {
        hit.slot = slot;
      }
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

  /** Returns whether what was hit is flat: a face, a plane or a cap. */
  public boolean isFlat(Hit hit) {
    return switch (kind(head[hit.slot]) % TRANSFORMED) {
      case SPHERE -> false;
      case CYLINDER -> CylinderKernel.isCap(hit);
      default -> true;
    };
  }

  /** Fills in point, normal, surface and offset of a hit that was found with this ray. */
  public void resolve(Ray ray, Hit hit, Ray local) {
    int number = surface[hit.slot];
    hit.stand(ray.time);
    if (motions != null && motions.moves(number)) {
      find(motions.still(number, ray), hit, local);
      motions.carry(number, ray, hit);
    } else {
      find(ray, hit, local);
    }
  }

  private void find(Ray ray, Hit hit, Ray local) {
    int slot = hit.slot;
    int at = start(head[slot]);
    int k = kind(head[slot]);
    hit.surface = surface[slot];
    hit.curved = false;
    if (k == INSTANCE || k == INSTANCE_IN_PARTS) {
      instances.resolve(at, hit);
      hit.surface += k == INSTANCE_IN_PARTS ? instances.part(at, hit) : 0;
    } else if (k >= TRANSFORMED) {
      TransformedKernel.toObject(data, at, ray, local);
      double t = hit.t;
      hit.t = t / local.unit;
      resolve(k - TRANSFORMED, at + TransformedKernel.SIZE, local, hit);
      TransformedKernel.toWorld(data, at, hit);
      hit.t = t;
    } else {
      resolve(k, at, ray, hit);
    }
  }

  /** Fills in point, normal and offset of a hit with the triangle in a slot. */
  void resolveTriangle(int slot, Hit hit) {
    TriangleKernel.resolve(data, start(head[slot]), hit);
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

  /**
   * Writes the box of a bounded primitive: least corner, then greatest, each to within a few
   * roundings.
   */
  public void bounds(int slot, double[] out) {
    int at = start(head[slot]);
    int k = kind(head[slot]);
    if (isInstance(slot)) {
      instances.bounds(at, out);
    } else if (k >= TRANSFORMED) {
      bounds(k - TRANSFORMED, at + TransformedKernel.SIZE, out);
      TransformedKernel.boundsToWorld(data, at, out);
    } else {
      bounds(k, at, out);
    }
    if (motions != null && motions.moves(surface[slot])) {
      motions.widen(surface[slot], out);
    }
  }

  private void bounds(int k, int at, double[] out) {
    switch (k) {
      case SPHERE -> SphereKernel.bounds(data, at, out);
      case BOX -> System.arraycopy(data, at, out, 0, 6);
      case CYLINDER -> CylinderKernel.bounds(data, at, out);
      default -> TriangleKernel.bounds(data, at, out);
    }
  }

  /** Returns the box around all bounded primitives; turned inside out if there are none. */
  double[] box() {
    double inf = Double.POSITIVE_INFINITY;
    double[] all = {inf, inf, inf, -inf, -inf, -inf};
    double[] one = new double[6];
    for (int slot = unbounded; slot < head.length; slot++) {
      bounds(slot, one);
      for (int axis = 0; axis < 3; axis++) {
        all[axis] = Math.min(all[axis], one[axis]);
        all[3 + axis] = Math.max(all[3 + axis], one[3 + axis]);
      }
    }
    return all;
  }

  private static long pack(int kind, int start, int number) {
    return (long) number << NUMBER_SHIFT | (long) start << START_SHIFT | kind;
  }

  private static int kind(long head) {
    return (int) head & (1 << START_SHIFT) - 1;
  }

  private static int start(long head) {
    return (int) (head >>> START_SHIFT) & MAX_DOUBLES;
  }

  private static int number(long head) {
    return (int) (head >>> NUMBER_SHIFT);
  }

  private static int sizeOf(int k) {
    if (k >= TRANSFORMED) {
      return TransformedKernel.SIZE + sizeOf(k - TRANSFORMED);
    }
    return switch (k) {
      case SPHERE -> SphereKernel.SIZE;
      case PLANE -> PlaneKernel.SIZE;
      case BOX -> BoxKernel.SIZE;
      case CYLINDER -> CylinderKernel.SIZE;
      case INSTANCE, INSTANCE_IN_PARTS -> 0;
      default -> TriangleKernel.SIZE;
    };
  }

  /** Collects surfaces in scene order. */
  public static final class Builder {

    private long[] head = new long[16];
    private int[] surface = new int[16];
    private double[] data = new double[256];
    private int count;
    private int used;
    private int next;
    private int degenerate;
    private int[] firstNumber = {};
    private double[] ways = {};
    private double conditioning = 1;

    /** The models that instances show, by mesh, and what they look like so far. */
    private final Map<Mesh, Integer> models = new HashMap<>();

    private final List<Primitives> shown = new ArrayList<>();
    private Transform[] places = new Transform[16];
    private int[] modelOf = new int[16];
    private int placed;

    /** What is known of instances already, else null. */
    private Instances instances;

    /** Begins without anything. */
    public Builder() {}

    /** Begins with what holds for all of some primitives, but none of them. */
    private Builder(Primitives other) {
      reserve(other.head.length, other.data.length);
      firstNumber = other.firstNumber;
      ways = other.motions == null ? ways : other.motions.ways();
      instances = other.instances;
      conditioning = other.conditioning;
      degenerate = other.degenerate;
    }

    private Instances instances() {
      if (instances == null) {
        Transform[] all = Arrays.copyOf(places, placed);
        instances = new Instances(List.copyOf(shown), all, Arrays.copyOf(modelOf, placed));
      }
      return instances;
    }

    /** Adds a surface, carried into the world by {@code toWorld}, under a surface number. */
    public void add(Surface shape, Transform toWorld, int number) {
      add(shape, toWorld, number, false);
    }

    /**
     * Adds a surface, carried into the world by {@code toWorld}.
     *
     * @param number the surface's
     * @param inParts whether each part of a mesh has a number of its own, in order from this one
     */
    public void add(Surface shape, Transform toWorld, int number, boolean inParts) {
      if (shape instanceof Sphere s) {
        addSphere(s, toWorld, number);
      } else if (shape instanceof Triangle t) {
        addFlat(List.of(t.a(), t.b(), t.c()), toWorld, number);
      } else if (shape instanceof Plane p) {
        Vector3d normal = toWorld.normal(p.normal().normalized());
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
      } else if (shape instanceof Mesh m) {
        addMesh(m, toWorld, number, inParts);
      }
    }

    /**
     * Lets surfaces move while the shutter is open.
     *
     * @param first the number of the first of them
     * @param count how many they are, as parts of one mesh
     */
    public void move(int first, int count, Vector3d way) {
      for (int i = first; i < first + count; i++) {
        ways = Motions.with(ways, i, way);
      }
    }

    /** Returns the primitives added so far, those without bounds first. */
    public Primitives build() {
      Primitives inOrder = new Primitives(this, 0);
      Builder sorted = new Builder(inOrder);
      int planes = 0;
      for (boolean bounded : new boolean[] {false, true}) {
        for (int i = 0; i < count; i++) {
          int k = kind(head[i]);
          if ((k != PLANE) == bounded) {
            sorted.put(k, data, start(head[i]), number(head[i]), surface[i]);
          }
        }
        planes = bounded ? planes : sorted.count;
      }
      return planes == 0 ? inOrder : new Primitives(sorted, planes);
    }

    private void addSphere(Sphere s, Transform toWorld, int number) {
      double scale = toWorld.uniformScale();
      if (scale > 0) {
        Vector3d center = toWorld.point(s.center());
        put(SPHERE, SphereKernel.pack(center, scale * s.radius()), number);
      } else {
        double unit = objectUnit(toWorld);
        Vector3d center = s.center().times(unit);
        double[] own = SphereKernel.pack(center, unit * s.radius());
        putTransformed(SPHERE, toWorld, unit, own, number);
      }
    }

    private void addBox(Box b, Transform toWorld, int number) {
      if (toWorld.isIdentity()) {
        put(BOX, BoxKernel.pack(b.min(), b.max()), number);
      } else {
        double unit = objectUnit(toWorld);
        double[] own = BoxKernel.pack(b.min().times(unit), b.max().times(unit));
        putTransformed(BOX, toWorld, unit, own, number);
      }
    }

    private void addCylinder(Cylinder c, Transform toWorld, int number) {
      Vector3d axis = c.top().minus(c.base());
      double scale = toWorld.uniformScale();
      if (scale > 0) {
        // The axis moves as a direction: a small cylinder far away keeps it in full.
        Vector3d base = toWorld.point(c.base());
        Vector3d turned = toWorld.direction(axis);
        double r = scale * c.radius();
        double topR = scale * c.topRadius();
        put(CYLINDER, CylinderKernel.pack(base, turned, r, topR, c.capped()), number);
      } else {
        double unit = objectUnit(toWorld);
        Vector3d base = c.base().times(unit);
        double r = unit * c.radius();
        double topR = unit * c.topRadius();
        double[] own = CylinderKernel.pack(base, axis.times(unit), r, topR, c.capped());
        putTransformed(CYLINDER, toWorld, unit, own, number);
      }
    }

    /** Adds every triangle; one whose corners a mirroring has turned over is reversed. */
    private void addMesh(Mesh m, Transform toWorld, int number, boolean inParts) {
      int end = number + (inParts ? m.parts() : 1);
      firstNumber = Arrays.copyOf(firstNumber, Math.max(firstNumber.length, end));
      Arrays.fill(firstNumber, number, end, next);
      reserve(count + m.triangles(), used + (long) TriangleKernel.SIZE * m.triangles());
      int k = toWorld.mirrors() ? REVERSED_TRIANGLE : TRIANGLE;
      double[] nine = new double[TriangleKernel.SIZE];
      double[] rows = toWorld.rows();
      for (int i = 0; i < m.triangles(); i++) {
        for (int j = 0; j < 3; j++) {
          double x = m.coordinate(i, j, 0);
          double y = m.coordinate(i, j, 1);
          double z = m.coordinate(i, j, 2);
          for (int axis = 0; axis < 3; axis++) {
            int row = 4 * axis;
            nine[3 * j + axis] =
                rows[row] * x + rows[row + 1] * y + rows[row + 2] * z + rows[row + 3];
          }
        }
        put(k, nine, inParts ? number + m.part(i) : number);
      }
    }

    /**
     * Adds a mesh at a place as an instance: the mesh is kept once, in its own space, however often
     * it is added.
     *
     * @param number the surface's
     * @param inParts whether each part of the mesh has a number of its own, in order from this one
     */
    public void show(Mesh mesh, Transform toWorld, int number, boolean inParts) {
      if (!models.containsKey(mesh)) {
        Builder own = new Builder();
        own.addMesh(mesh, Transform.IDENTITY, 0, true);
        Primitives model = own.build();
        degenerate += model.degenerate;
        models.put(mesh, shown.size());
        shown.add(model);
      }
      int id = next++;
      int model = models.get(mesh);
      if (shown.get(model).count() == 0) {
        return; // there is nothing to hit
      }
      if (placed == places.length) {
        places = Arrays.copyOf(places, 2 * placed);
        modelOf = Arrays.copyOf(modelOf, 2 * placed);
      }
      places[placed] = toWorld;
      modelOf[placed] = model;
      conditioning = Math.max(conditioning, toWorld.flattening());
      put(inParts ? INSTANCE_IN_PARTS : INSTANCE, data, placed++, id, number);
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
    private void addPolygon(List<Vector3d> corners, int k, int number) {
      for (int i = 2; i < corners.size(); i++) {
        double[] three = TriangleKernel.pack(corners.get(0), corners.get(i - 1), corners.get(i));
        put(k, three, number);
      }
    }

    /**
     * The power of two by which object space is multiplied, so that no length grows by much on its
     * way there: what can be held in the world can be held there.
     */
    private static double objectUnit(Transform toWorld) {
      return Math.scalb(1.0, -Math.getExponent(toWorld.inverted().largest()));
    }

    private void putTransformed(int k, Transform toWorld, double unit, double[] data, int number) {
      double own = k == BOX ? toWorld.conditioning() : toWorld.flattening();
      conditioning = Math.max(conditioning, own);
      double back = 1 / unit;
      Transform scaled = Transform.scale(new Vector3d(back, back, back)).then(toWorld);
      put(k + TRANSFORMED, TransformedKernel.pack(scaled, data), number);
    }

    /** Adds a primitive under the next number, unless it is a triangle that is never hit. */
    private void put(int k, double[] numbers, int ofSurface) {
      int id = next++;
      boolean triangle = k == TRIANGLE || k == REVERSED_TRIANGLE;
      if (triangle && !TriangleKernel.hasArea(numbers)) {
        degenerate++;
      } else {
        put(k, numbers, 0, id, ofSurface);
      }
    }

    private void put(int k, double[] from, int at, int id, int ofSurface) {
      int size = sizeOf(k);
      if (count == head.length || used + size > data.length) {
        long twice = Math.min(2L * data.length, MAX_DOUBLES);
        reserve(Math.max(count + 1, 2 * head.length), Math.max((long) used + size, twice));
      }
      head[count] = pack(k, size == 0 ? at : used, id);
      surface[count] = ofSurface;
      if (size > 0) {
        System.arraycopy(from, at, data, used, size);
      }
      used += size;
      count++;
    }

    /** Makes room; throws if what is asked for cannot be addressed. */
    private void reserve(int primitives, long doubles) {
      if (doubles > MAX_DOUBLES) {
        throw new IllegalArgumentException("the scene has more surfaces than Glint can hold");
      }
      head = Arrays.copyOf(head, primitives);
      surface = Arrays.copyOf(surface, primitives);
      data = Arrays.copyOf(data, (int) doubles);
    }
  }
}
