package glint.accel;

import glint.geometry.Primitives;
import java.util.concurrent.RecursiveAction;

/**
 * Builds a bounding volume hierarchy top down by the surface area heuristic, in parallel.
 *
 * <p>Source: I. Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007. A
 * subtree of n primitives owns n - 1 node numbers from its root's on, so the tree does not depend
 * on which thread built what.
 */
final class BvhBuilder {

  private static final int BINS = 16;

  /** Leaves hold at most this many primitives. */
  static final int MAX_LEAF = 4;

  /** Below this depth splits are by count, which bounds the depth for any input. */
  static final int SAH_DEPTH = 32;

  /** Subtrees from this size on are built by a task of their own. */
  private static final int PARALLEL = 4096;

  /** The cost of a step through a node, in primitive tests. */
  private static final float STEP = 1;

  final int count;

  /** Boxes of primitives, six floats each: least corner, greatest corner, rounded outward. */
  final float[] boxes;

  /** Primitives in the order of leaves. */
  final int[] order;

  /** Boxes of the two children of every node, twelve floats each. */
  final float[] childBoxes;

  /** The two children of every node: a node number, or the complement of a packed leaf. */
  final int[] children;

  /** Whether a node number is in use. */
  final boolean[] used;

  BvhBuilder(Primitives primitives, double margin) {
    int first = primitives.unbounded();
    count = primitives.count() - first;
    boxes = new float[6 * count];
    order = new int[count];
    double[] box = new double[6];
    for (int i = 0; i < count; i++) {
      primitives.bounds(first + i, box);
      for (int axis = 0; axis < 3; axis++) {
        boxes[6 * i + axis] = roundDown(box[axis] - margin);
        boxes[6 * i + 3 + axis] = roundUp(box[3 + axis] + margin);
      }
      order[i] = i;
    }
    int nodes = Math.max(1, count - 1);
    childBoxes = new float[12 * nodes];
    children = new int[2 * nodes];
    used = new boolean[nodes];
  }

  /** Builds the tree over two primitives or more; its root is node 0. */
  void build() {
    new Subtree(0, count, 0, 0).invoke();
  }

  static float roundDown(double v) {
    float f = (float) v;
    return f > v ? Math.nextDown(f) : f;
  }

  static float roundUp(double v) {
    float f = (float) v;
    return f < v ? Math.nextUp(f) : f;
  }

  /** A leaf of {@code size} primitives from {@code start} in leaf order. */
  static int leaf(int start, int size) {
    return ~(start << 3 | size);
  }

  /** Splits a range of primitives at a node and both halves after it. */
  private final class Subtree extends RecursiveAction {

    private static final long serialVersionUID = 1;

    private final int start;
    private final int end;
    private final int node;
    private final int depth;

    Subtree(int start, int end, int node, int depth) {
      this.start = start;
      this.end = end;
      this.node = node;
      this.depth = depth;
    }

    @Override
    protected void compute() {
      used[node] = true;
      Split split = new Split(start, end);
      int middle = depth < SAH_DEPTH ? split.bySurfaceArea() : split.byCount();
      Subtree left = child(0, start, middle, node + 1);
      Subtree right = child(1, middle, end, node + (middle - start));
      if (left != null && right != null && end - start >= PARALLEL) {
        invokeAll(left, right);
        return;
      }
      if (left != null) {
        left.compute();
      }
      if (right != null) {
        right.compute();
      }
    }

    /** Stores a child's box, and the child itself if it is a leaf; else returns its subtree. */
    private Subtree child(int side, int from, int to, int number) {
      bound(from, to, childBoxes, 12 * node + 6 * side);
      int size = to - from;
      boolean isLeaf = size == 1 || (size <= MAX_LEAF && new Split(from, to).isBestWhole());
      children[2 * node + side] = isLeaf ? leaf(from, size) : number;
      return isLeaf ? null : new Subtree(from, to, number, depth + 1);
    }
  }

  private void bound(int from, int to, float[] out, int at) {
    for (int axis = 0; axis < 3; axis++) {
      float least = Float.POSITIVE_INFINITY;
      float greatest = Float.NEGATIVE_INFINITY;
      for (int i = from; i < to; i++) {
        least = Math.min(least, boxes[6 * order[i] + axis]);
        greatest = Math.max(greatest, boxes[6 * order[i] + 3 + axis]);
      }
      out[at + axis] = least;
      out[at + 3 + axis] = greatest;
    }
  }

  /** A way to divide a range of primitives in two. */
  private final class Split {

    private final int start;
    private final int end;

    /** Where each bin of the centroids' extent begins, per axis: origin and bins per unit. */
    private final float[] origin = new float[3];

    private final float[] scale = new float[3];

    private int bestAxis = -1;
    private int bestBin;
    private double bestCost = Double.POSITIVE_INFINITY;

    Split(int start, int end) {
      this.start = start;
      this.end = end;
      findExtent();
    }

    private void findExtent() {
      for (int axis = 0; axis < 3; axis++) {
        float least = Float.POSITIVE_INFINITY;
        float greatest = Float.NEGATIVE_INFINITY;
        for (int i = start; i < end; i++) {
          float c = centroid(order[i], axis);
          least = Math.min(least, c);
          greatest = Math.max(greatest, c);
        }
        origin[axis] = least;
        float bins = BINS * 0.999999f / (greatest - least);
        scale[axis] = bins > 0 && bins < Float.POSITIVE_INFINITY ? bins : 0;
      }
    }

    /** Returns whether testing all primitives costs no more than the best split. */
    boolean isBestWhole() {
      findBest();
      float[] whole = new float[6];
      bound(start, end, whole, 0);
      double area = area(whole, 0);
      return !(STEP * area + bestCost < (end - start) * area);
    }

    /**
     * Partitions the range at the best of all bin borders; returns where the second half begins.
     */
    int bySurfaceArea() {
      findBest();
      if (bestAxis < 0) {
        return byCount();
      }
      int i = start;
      int j = end - 1;
      while (i <= j) {
        if (bin(order[i], bestAxis) <= bestBin) {
          i++;
        } else {
          swap(i, j--);
        }
      }
      return i;
    }

    /** Halves the range by count along the axis of the widest extent (Hoare's selection). */
    int byCount() {
      int axis = scale[0] > 0 ? 0 : -1;
      for (int a = 1; a < 3; a++) {
        if (scale[a] > 0 && (axis < 0 || scale[a] < scale[axis])) {
          axis = a;
        }
      }
      int middle = (start + end) >>> 1;
      if (axis >= 0) {
        select(middle, axis);
      }
      return middle;
    }

    private void select(int middle, int axis) {
      int low = start;
      int high = end - 1;
      while (low < high) {
        float pivot = centroid(order[(low + high) >>> 1], axis);
        int i = low;
        int j = high;
        while (i <= j) {
          while (centroid(order[i], axis) < pivot) {
            i++;
          }
          while (centroid(order[j], axis) > pivot) {
            j--;
          }
          if (i <= j) {
            swap(i++, j--);
          }
        }
        if (middle <= j) {
          high = j;
        } else if (middle >= i) {
          low = i;
        } else {
          return;
        }
      }
    }

    private void findBest() {
      for (int axis = 0; axis < 3; axis++) {
        if (scale[axis] > 0) {
          sweep(axis);
        }
      }
    }

    /** Tries the borders between the bins of an axis. */
    private void sweep(int axis) {
      float[] box = new float[6 * BINS];
      int[] size = new int[BINS];
      for (int b = 0; b < BINS; b++) {
        clear(box, 6 * b);
      }
      for (int i = start; i < end; i++) {
        int b = bin(order[i], axis);
        size[b]++;
        grow(box, 6 * b, boxes, 6 * order[i]);
      }
      // Sum up areas times counts from the right, then from the left.
      double[] right = new double[BINS];
      float[] sum = new float[6];
      clear(sum, 0);
      int behind = 0;
      for (int b = BINS - 1; b > 0; b--) {
        grow(sum, 0, box, 6 * b);
        behind += size[b];
        right[b - 1] = behind == 0 ? 0 : behind * area(sum, 0);
      }
      clear(sum, 0);
      int before = 0;
      for (int b = 0; b < BINS - 1; b++) {
        grow(sum, 0, box, 6 * b);
        before += size[b];
        double cost = before * area(sum, 0) + right[b];
        if (before > 0 && before < end - start && cost < bestCost) {
          bestCost = cost;
          bestAxis = axis;
          bestBin = b;
        }
      }
    }

    private int bin(int primitive, int axis) {
      int b = (int) ((centroid(primitive, axis) - origin[axis]) * scale[axis]);
      return Math.min(Math.max(b, 0), BINS - 1);
    }
  }

  /** The middle of a primitive's box, halved first so that it does not overflow. */
  private float centroid(int primitive, int axis) {
    return 0.5f * boxes[6 * primitive + axis] + 0.5f * boxes[6 * primitive + 3 + axis];
  }

  private void swap(int i, int j) {
    int o = order[i];
    order[i] = order[j];
    order[j] = o;
  }

  private static void clear(float[] box, int at) {
    for (int axis = 0; axis < 3; axis++) {
      box[at + axis] = Float.POSITIVE_INFINITY;
      box[at + 3 + axis] = Float.NEGATIVE_INFINITY;
    }
  }

  private static void grow(float[] box, int at, float[] other, int from) {
    for (int axis = 0; axis < 3; axis++) {
      box[at + axis] = Math.min(box[at + axis], other[from + axis]);
      box[at + 3 + axis] = Math.max(box[at + 3 + axis], other[from + 3 + axis]);
    }
  }

  /** Half the surface of a box; in doubles, since floats would overflow. */
  private static double area(float[] box, int at) {
    double x = (double) box[at + 3] - box[at];
    double y = (double) box[at + 4] - box[at + 1];
    double z = (double) box[at + 5] - box[at + 2];
    return x * y + y * z + z * x;
  }
}
