package glint.accel;

import glint.geometry.Hit;
import glint.geometry.Primitives;
import glint.geometry.Ray;

/**
 * Finds what a ray hits; owns the scratch for it, so one per worker.
 *
 * <p>Unbounded primitives are tried one by one, and so is everything where there is no tree; both
 * ways give the same hit, bit for bit, because a hit depends on ray and primitive alone and equal
 * parameters go to the lower number.
 */
public final class Intersector {

  /**
   * The least magnitude of a direction component in the tree, so that no slab computes 0·∞. A ray
   * that runs so straight leaves a slab by far less than a box's margin.
   */
  private static final double LEAST_COMPONENT = 1e-150;

  /**
   * How far, in units of u times the largest coordinate at hand, a kernel's hit may lie off its
   * primitive, with room for the slab's own rounding.
   *
   * <p>The widest band of any kernel is the cylinder's, 36u(|o - c| + size), and that sum is at
   * most 2√3 + 1 times the largest coordinate: 161u. See docs/numerics.md.
   */
  private static final double SLACK = 256 * 0x1p-53;

  /** In place of a node: nothing. No leaf is packed like that. */
  private static final int END = Integer.MIN_VALUE;

  private final Primitives primitives;
  private final Bvh tree;
  private final Ray local = new Ray();

  /** Searches of the models that instances show, and whether there are any. */
  private final Intersector[] models;

  private final boolean instanced;

  /** Where this is a search of a model: the ray as the model sees it, and what it hits. */
  private final Ray inModel = new Ray();

  private final Hit found = new Hit();
  private final int[] stack = new int[Bvh.MAX_DEPTH];
  private final int[] stackNear = new int[Bvh.MAX_DEPTH];

  private long nodesVisited;

  // The ray as slabs see it: reciprocal direction, and origins moved apart for near and far planes.
  private double inverseX;
  private double inverseY;
  private double inverseZ;
  private double nearX;
  private double nearY;
  private double nearZ;
  private double farX;
  private double farY;
  private double farZ;

  /** Searches a tree. */
  public Intersector(Bvh tree) {
    this.primitives = tree.primitives();
    this.tree = tree;
    models = tree.models.stream().map(Intersector::new).toArray(Intersector[]::new);
    instanced = models.length > 0;
  }

  /** Searches without a tree: the fastest way for a handful, and the reference for any tree. */
  public Intersector(Primitives primitives) {
    this.primitives = primitives;
    this.tree = null;
    models = primitives.models().stream().map(Intersector::new).toArray(Intersector[]::new);
    instanced = models.length > 0;
  }

  /** Finds the hit with the least t in {@code (ray.tMin, tMax]}. */
  public void closest(Ray ray, double tMax, Hit hit) {
    hit.begin(tMax);
    search(ray, hit, false);
  }

  /** Returns whether anything is hit in {@code (ray.tMin, tMax]}. */
  public boolean any(Ray ray, double tMax, Hit scratch) {
    scratch.begin(tMax);
    search(ray, scratch, true);
    return scratch.found();
  }

  /** Fills in point, normal and surface of a hit that was found with this ray. */
  public void resolve(Ray ray, Hit hit) {
    primitives.resolve(ray, hit, local);
  }

  /** Returns how many nodes of the tree, and of those over models, were looked at so far. */
  public long nodesVisited() {
    long all = nodesVisited;
    for (Intersector model : models) {
      all += model.nodesVisited();
    }
    return all;
  }

  /** Offers the hit of a ray with the primitive in one slot, which may be a model at a place. */
  public void intersect(int slot, Ray ray, Hit hit) {
    intersect(slot, ray, hit, false);
  }

  private void intersect(int slot, Ray ray, Hit hit, boolean stopAtFirst) {
    if (instanced && primitives.isInstance(slot)) {
      Intersector model = models[primitives.model(slot)];
      primitives.toModel(slot, ray, hit, model.inModel);
      model.found.begin(hit.t);
      model.search(model.inModel, model.found, stopAtFirst);
      primitives.offer(slot, model.found, hit);
    } else {
      primitives.intersect(slot, ray, hit, local);
    }
  }

  private void intersectAll(int slot, int end, Ray ray, Hit hit, boolean stopAtFirst) {
    for (int i = slot; i < end && !(stopAtFirst && hit.found()); i++) {
      intersect(i, ray, hit, stopAtFirst);
    }
  }

  private void search(Ray ray, Hit hit, boolean stopAtFirst) {
    int linear = tree == null ? primitives.count() : primitives.unbounded();
    intersectAll(0, linear, ray, hit, stopAtFirst);
    if (stopAtFirst && hit.found()) {
      return;
    }
    if (linear < primitives.count()) {
      prepare(ray);
      walk(ray, hit, stopAtFirst);
    }
  }

  /**
   * Moves the origin back for near planes and forward for far ones, axis by axis.
   *
   * <p>A slab's t, (plane - o)·(1/d), is off by at most 3 roundings: as if the plane were moved by
   * 3u|plane - o|. A kernel's hit lies off its primitive by a few u(|o| + |primitive|), times the
   * conditioning of a transform. Moving the planes apart by more than both misses no hit.
   */
  private void prepare(Ray ray) {
    double reach =
        tree.size + Math.max(Math.abs(ray.ox), Math.max(Math.abs(ray.oy), Math.abs(ray.oz)));
    reach += 0 * (reach + ray.dx + ray.dy + ray.dz); // NaN, which no box is near, if not finite
    double slack = SLACK * primitives.conditioning() * reach;
    double dx = steep(ray.dx);
    double dy = steep(ray.dy);
    double dz = steep(ray.dz);
    inverseX = 1 / dx;
    inverseY = 1 / dy;
    inverseZ = 1 / dz;
    nearX = dx > 0 ? ray.ox + slack : ray.ox - slack;
    nearY = dy > 0 ? ray.oy + slack : ray.oy - slack;
    nearZ = dz > 0 ? ray.oz + slack : ray.oz - slack;
    farX = dx > 0 ? ray.ox - slack : ray.ox + slack;
    farY = dy > 0 ? ray.oy - slack : ray.oy + slack;
    farZ = dz > 0 ? ray.oz - slack : ray.oz + slack;
  }

  private static double steep(double d) {
    return Math.abs(d) < LEAST_COMPONENT ? Math.copySign(LEAST_COMPONENT, d) : d;
  }

  private void walk(Ray ray, Hit hit, boolean stopAtFirst) {
    int[] nodes = tree.nodes;
    int bounded = primitives.unbounded();
    // Choose the near and far plane of each slab by the sign of the direction.
    int lowX = inverseX > 0 ? 0 : 3;
    int lowY = inverseY > 0 ? 1 : 4;
    int lowZ = inverseZ > 0 ? 2 : 5;
    int highX = 3 - lowX;
    int highY = 5 - lowY;
    int highZ = 7 - lowZ;
    double scale = ray.perWorldUnit();
    int start = bits(ray.tMin * scale);
    int end = bits(hit.t * scale);
    int top = 0;
    int node = tree.root;
    while (node != END) {
      while (node >= 0) {
        nodesVisited++;
        int near0 = enter(nodes, node + lowX, node + lowY, node + lowZ, start);
        int far0 = leave(nodes, node + highX, node + highY, node + highZ, end);
        int near1 = enter(nodes, node + 6 + lowX, node + 6 + lowY, node + 6 + lowZ, start);
        int far1 = leave(nodes, node + 6 + highX, node + 6 + highY, node + 6 + highZ, end);
        int first = nodes[node + Bvh.CHILDREN];
        int second = nodes[node + Bvh.CHILDREN + 1];
        if (near0 <= far0 && near1 <= far1) {
          // Visit the nearer child first, the other one later.
          boolean swap = near1 < near0;
          node = swap ? second : first;
          stack[top] = swap ? first : second;
          stackNear[top++] = swap ? near0 : near1;
        } else if (near0 <= far0) {
          node = first;
        } else if (near1 <= far1) {
          node = second;
        } else {
          node = END;
          break;
        }
      }
      if (node != END) {
        int slot = bounded + Bvh.leafStart(node);
        int last = slot + Bvh.leafSize(node);
        if (instanced) {
          intersectAll(slot, last, ray, hit, stopAtFirst);
        } else {
          for (; slot < last; slot++) {
            primitives.intersectBounded(slot, ray, hit, local);
          }
        }
        if (stopAtFirst && hit.found()) {
          return;
        }
        end = bits(hit.t * scale);
      }
      // Take up the next child that begins before the closest hit.
      node = END;
      while (top > 0 && node == END) {
        top--;
        node = stackNear[top] <= end ? stack[top] : END;
      }
    }
  }

  /**
   * The t at which a ray has entered all three slabs, not before {@code start}.
   *
   * <p>Numbers are compared by the upper halves of their bits. For those of zero and above, which a
   * maximum with {@code start} is, that never turns an order round, so no box is missed; and the
   * maxima and minima of ints need no branch, which incoherent rays would often mispredict.
   */
  private int enter(int[] nodes, int x, int y, int z, int start) {
    int tx = bits((Float.intBitsToFloat(nodes[x]) - nearX) * inverseX);
    int ty = bits((Float.intBitsToFloat(nodes[y]) - nearY) * inverseY);
    int tz = bits((Float.intBitsToFloat(nodes[z]) - nearZ) * inverseZ);
    return Math.max(Math.max(tx, ty), Math.max(tz, start));
  }

  /** The t at which a ray leaves the first of three slabs, at most {@code end}; or below zero. */
  private int leave(int[] nodes, int x, int y, int z, int end) {
    int tx = bits((Float.intBitsToFloat(nodes[x]) - farX) * inverseX);
    int ty = bits((Float.intBitsToFloat(nodes[y]) - farY) * inverseY);
    int tz = bits((Float.intBitsToFloat(nodes[z]) - farZ) * inverseZ);
    return Math.min(Math.min(tx, ty), Math.min(tz, end));
  }

  private static int bits(double t) {
    return (int) (Double.doubleToRawLongBits(t) >> 32);
  }
}
