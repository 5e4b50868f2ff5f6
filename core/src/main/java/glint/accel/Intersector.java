package glint.accel;

import glint.geometry.Hit;
import glint.geometry.Primitives;
import glint.geometry.Ray;
import java.util.stream.Stream;

/**
 * Finds what a ray hits; owns the scratch for it, so one per worker.
 *
 * <p>Unbounded primitives are tried one by one, and so is a handful of others, as far as the ray
 * meets their boxes; more are in a tree. A ray of a pencil tries what is on its list. All ways give
 * the same hit, bit for bit, because a hit depends on ray and primitive alone and equal parameters
 * go to the lower number.
 */
public final class Intersector {

  /** In place of a node: nothing. No leaf is packed like that. */
  private static final int END = Integer.MIN_VALUE;

  /** From here on a t has all of its bits in a model as well, which is scaled by at most 2^160. */
  private static final double LEAST_T = 0x1p-800;

  private final Primitives primitives;

  /** The tree over the primitives, or else the boxes around them; null where not used. */
  private final Bvh tree;

  private final Boxes boxes;

  /** The largest coordinate of the boxes. */
  private final double size;

  private final Ray local = new Ray();

  /** Searches of the models that instances show, and whether there are any. */
  private final Intersector[] models;

  private final boolean instanced;

  /** Where this is a search of a model: the ray as the model sees it, and what it hits. */
  private final Ray inModel = new Ray();

  private final Hit found = new Hit();
  private final int[] stack = new int[Bvh.MAX_DEPTH];
  private final int[] stackNear = new int[Bvh.MAX_DEPTH];

  private final Slabs slabs = new Slabs();
  private long nodesVisited;

  /** Searches a tree. */
  public Intersector(Bvh tree) {
    this(tree.primitives(), tree, null, tree.size, tree.models.stream().map(Intersector::new));
  }

  /** Tries what has boxes around it, no models: the fastest way for a handful. */
  public Intersector(Boxes boxes) {
    this(boxes.primitives, null, boxes, boxes.size, Stream.of());
  }

  /** Tries everything: the reference for any other way. */
  public Intersector(Primitives all) {
    this(all, null, null, 0, all.models().stream().map(Intersector::new));
  }

  private Intersector(
      Primitives primitives, Bvh tree, Boxes boxes, double size, Stream<Intersector> models) {
    this.primitives = primitives;
    this.tree = tree;
    this.boxes = boxes;
    this.size = size;
    this.models = models.toArray(Intersector[]::new);
    instanced = this.models.length > 0;
  }

  /** Finds the hit with the least t in {@code (ray.tMin, tMax]}. */
  public void closest(Ray ray, double tMax, Hit hit) {
    closest(ray, tMax, null, hit);
  }

  /**
   * Does the same for a ray that may be one of a pencil.
   *
   * @param pencil of the same primitives, or null
   */
  public void closest(Ray ray, double tMax, Pencil pencil, Hit hit) {
    hit.begin(tMax);
    search(ray, hit, pencil, false);
  }

  /**
   * Returns whether it is certain that a ray meets nothing else from the hit that {@link #closest}
   * found up to a parameter; what coincides with it counts as else.
   *
   * <p>The search left out only boxes whose t has a greater upper half of its bits.
   */
  public boolean isAlone(Hit hit, double end) {
    return hit.next > end && Slabs.bits(end) == Slabs.bits(hit.t) && hit.t >= LEAST_T;
  }

  /** Returns whether anything is hit in {@code (ray.tMin, tMax]}. */
  public boolean any(Ray ray, double tMax, Hit scratch) {
    return blocker(ray, tMax, null, -1, scratch) >= 0;
  }

  /**
   * Does the same, but tries one primitive before others: what was in the way of the last ray is
   * likely to be in that of the next.
   *
   * @param pencil which the ray may be one of, or null
   * @param first the slot of the one tried first, or -1 for none
   * @return the slot of what is hit, or -1
   */
  public int blocker(Ray ray, double tMax, Pencil pencil, int first, Hit scratch) {
    scratch.begin(tMax);
    if (first >= 0) {
      intersect(first, ray, scratch, true);
    }
    if (!scratch.found()) {
      search(ray, scratch, pencil, true);
    }
    return scratch.found() ? scratch.slot() : -1;
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
      model.search(model.inModel, model.found, null, stopAtFirst);
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

  private void search(Ray ray, Hit hit, Pencil pencil, boolean stopAtFirst) {
    boolean boxed = tree != null || boxes != null;
    int linear = boxed ? primitives.unbounded() : primitives.count();
    intersectAll(0, linear, ray, hit, stopAtFirst);
    if (linear == primitives.count() || (stopAtFirst && hit.found())) {
      return;
    }
    int list = pencil == null ? Cells.MANY : pencil.list(ray);
    if (list == Cells.MANY) {
      slabs.set(ray, size, primitives.conditioning());
      if (tree == null) {
        scan(ray, hit, stopAtFirst);
      } else {
        walk(tree.root, ray, hit, stopAtFirst);
      }
    } else if (pencil.inParts()) {
      walkParts(pencil, list, ray, hit, stopAtFirst);
    } else {
      int start = Cells.start(list);
      int end = start + Cells.length(list);
      double perT = pencil.depthPerT(ray);
      double most = pencil.begin(ray);
      for (int i = start; i < end && !(stopAtFirst && hit.found()); i++) {
        if (pencil.depth(i) > most) {
          return;
        }
        intersect(pencil.slot(i), ray, hit, stopAtFirst);
        if (perT > 0) {
          most = perT * hit.t;
        }
      }
    }
  }

  /** Tries everything whose box the ray meets before the closest hit so far. */
  private void scan(Ray ray, Hit hit, boolean stopAtFirst) {
    int[] bits = boxes.bits;
    int next = 0;
    double scale = ray.perWorldUnit();
    int start = Slabs.bits(ray.tMin * scale);
    int end = Slabs.bits(hit.t * scale);
    for (int at = 0; at < bits.length && !(stopAtFirst && hit.found()); at += 6) {
      if (slabs.enter(bits, at, start) <= slabs.leave(bits, at, end)) {
        primitives.intersect(boxes.slots[next], ray, hit, local);
        end = Slabs.bits(hit.t * scale);
      }
      next++;
    }
  }

  /** Walks through the subtrees on a list whose boxes the ray meets before the closest hit. */
  private void walkParts(Pencil pencil, int list, Ray ray, Hit hit, boolean stopAtFirst) {
    slabs.set(ray, size, primitives.conditioning());
    int[] nodes = tree.nodes;
    double scale = ray.perWorldUnit();
    int start = Slabs.bits(ray.tMin * scale);
    int last = Cells.start(list) + Cells.length(list);
    for (int i = Cells.start(list); i < last && !(stopAtFirst && hit.found()); i++) {
      int place = pencil.part(i);
      int end = Slabs.bits(hit.t * scale);
      if (slabs.enter(nodes, place, start) <= slabs.leave(nodes, place, end)) {
        walk(Bvh.child(nodes, place), ray, hit, stopAtFirst);
      }
    }
  }

  /** Walks through a subtree. */
  private void walk(int from, Ray ray, Hit hit, boolean stopAtFirst) {
    int[] nodes = tree.nodes;
    int bounded = primitives.unbounded();
    double scale = ray.perWorldUnit();
    int start = Slabs.bits(ray.tMin * scale);
    int end = Slabs.bits(hit.t * scale);
    int top = 0;
    int node = from;
    while (node != END) {
      while (node >= 0) {
        nodesVisited++;
        int near0 = slabs.enter(nodes, node, start);
        int far0 = slabs.leave(nodes, node, end);
        int near1 = slabs.enter(nodes, node + 6, start);
        int far1 = slabs.leave(nodes, node + 6, end);
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
        end = Slabs.bits(hit.t * scale);
      }
      // Take up the next child that begins before the closest hit.
      node = END;
      while (top > 0 && node == END) {
        top--;
        node = stackNear[top] <= end ? stack[top] : END;
      }
    }
  }
}
