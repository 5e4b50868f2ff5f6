package glint.accel;

import glint.geometry.Primitives;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A bounding volume hierarchy over the bounded primitives of a scene, in flat arrays; immutable.
 *
 * <p>A node holds the boxes of both its children, so that a ray decides about two boxes with one
 * look into memory. Boxes are floats rounded outward, and wider than what they hold by the scene's
 * size times 2^-40.
 */
public final class Bvh {

  /** No path from the root to a leaf is longer: see {@link BvhBuilder#SAH_DEPTH}. */
  static final int MAX_DEPTH = 64;

  /** How many ints a box takes. */
  static final int BOX = 6;

  /** How many ints a node takes. */
  static final int NODE = 14;

  /** Where in a node the children stand. */
  static final int CHILDREN = 12;

  /** The primitives, unbounded ones first, then those of leaf after leaf. */
  private final Primitives primitives;

  /**
   * The nodes, all that a visit needs in one place: the bits of twelve floats, the least and the
   * greatest corner of the first child, then of the second; and two children, each the place of a
   * node in this array or a packed leaf.
   */
  final int[] nodes;

  /** The largest absolute coordinate of the bounded primitives' boxes. */
  final double size;

  /** Where a walk begins: the first node, at 0, or a leaf that holds the few there are. */
  final int root;

  /** The trees over the models that instances show. */
  final List<Bvh> models;

  private Bvh(Primitives primitives, List<Bvh> models, double size, int root, int[] nodes) {
    this.primitives = primitives;
    this.models = models;
    this.size = size;
    this.root = root;
    this.nodes = nodes;
  }

  /** Builds a tree, and one over each model. */
  public static Bvh over(Primitives primitives) {
    List<Bvh> models = primitives.models().stream().map(Bvh::over).collect(Collectors.toList());
    List<Primitives> shown = models.stream().map(Bvh::primitives).collect(Collectors.toList());
    double size = Boxes.largestCoordinate(primitives);
    BvhBuilder builder = new BvhBuilder(primitives, size * Boxes.MARGIN);
    int root = builder.build();
    // Close the gaps that leaves of several primitives left in the numbering.
    int[] place = new int[builder.used.length];
    int end = 0;
    for (int i = 0; i < place.length; i++) {
      place[i] = end;
      end += builder.used[i] ? NODE : 0;
    }
    int[] nodes = new int[end];
    for (int i = 0; i < place.length; i++) {
      if (builder.used[i]) {
        for (int j = 0; j < CHILDREN; j++) {
          nodes[place[i] + j] = Float.floatToIntBits(builder.childBoxes[CHILDREN * i + j]);
        }
        for (int side = 0; side < 2; side++) {
          int child = builder.children[2 * i + side];
          nodes[place[i] + CHILDREN + side] = child < 0 ? child : place[child];
        }
      }
    }
    Primitives ordered = primitives.reordered(builder.order, shown);
    return new Bvh(ordered, models, size, root, nodes);
  }

  /** Returns the primitives in the order in which this tree refers to them. */
  public Primitives primitives() {
    return primitives;
  }

  /** Returns the largest absolute coordinate of the bounded primitives' boxes. */
  public double size() {
    return size;
  }

  /** Returns the number of nodes. */
  public int nodes() {
    return nodes.length / NODE;
  }

  /** Returns what the nodes take in memory, those over models included. */
  public long bytes() {
    return 4L * nodes.length + models.stream().mapToLong(Bvh::bytes).sum();
  }

  /** Returns the longest path from the root to a leaf, counted in nodes. */
  public int depth() {
    return depth(root);
  }

  private int depth(int node) {
    if (node < 0) {
      return 0;
    }
    return 1 + Math.max(depth(nodes[node + CHILDREN]), depth(nodes[node + CHILDREN + 1]));
  }

  /**
   * Returns the least distance, over all nodes, from a child's box to the boxes of what it holds;
   * infinite if there is no node.
   */
  public double tightestMargin() {
    double[] box = new double[6];
    return root < 0 ? Double.POSITIVE_INFINITY : margin(root, box);
  }

  /** The least margin at and below a node, and the box of all primitives below it. */
  private double margin(int child, double[] held) {
    Arrays.fill(held, 0, 3, Double.POSITIVE_INFINITY);
    Arrays.fill(held, 3, 6, Double.NEGATIVE_INFINITY);
    double least = Double.POSITIVE_INFINITY;
    double[] one = new double[6];
    if (child < 0) {
      int slot = primitives.unbounded() + leafStart(child);
      for (int i = 0; i < leafSize(child); i++) {
        primitives.bounds(slot + i, one);
        merge(held, one);
      }
      return least;
    }
    for (int side = 0; side < 2; side++) {
      least = Math.min(least, margin(nodes[child + CHILDREN + side], one));
      merge(held, one);
      for (int axis = 0; axis < 3; axis++) {
        int at = child + 6 * side + axis;
        double low = Float.intBitsToFloat(nodes[at]);
        double high = Float.intBitsToFloat(nodes[at + 3]);
        double room = Math.min(one[axis] - low, high - one[3 + axis]);
        least = Math.min(least, room);
      }
    }
    return least;
  }

  /** Returns the child, as in {@link #nodes}, whose box begins at a place there. */
  static int child(int[] nodes, int place) {
    int node = place - place % NODE;
    return nodes[node + CHILDREN + (place - node) / BOX];
  }

  private static void merge(double[] box, double[] other) {
    for (int axis = 0; axis < 3; axis++) {
      box[axis] = Math.min(box[axis], other[axis]);
      box[3 + axis] = Math.max(box[3 + axis], other[3 + axis]);
    }
  }

  /** Returns a leaf of {@code size} primitives from {@code start} on. */
  static int leaf(int start, int size) {
    return ~(start << 3 | size);
  }

  /** Returns the first primitive of a leaf, counted among the bounded ones. */
  static int leafStart(int child) {
    return ~child >>> 3;
  }

  /** Returns the number of primitives in a leaf. */
  static int leafSize(int child) {
    return ~child & 7;
  }
}
