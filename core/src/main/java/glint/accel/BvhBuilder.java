package glint.accel;

import glint.geometry.Primitives;
import java.util.concurrent.RecursiveTask;

/**
 * Builds a bounding volume hierarchy from the top down, in parallel.
 *
 * <p>A subtree of n primitives owns n - 1 node numbers from its root's on, so the tree does not
 * depend on which thread built what.
 */
final class BvhBuilder {

  /** Leaves hold at most this many primitives. */
  private static final int MAX_LEAF = 4;

  /**
   * Below this depth ranges are halved by count: the depth is at most this and log₂ of the number
   * of primitives, for any input.
   */
  static final int SAH_DEPTH = 32;

  /** Subtrees from this size on are built by a task of their own. */
  private static final int PARALLEL = 4096;

  /** The cost of a step through a node, in primitive tests: mostly a wait for memory. */
  private static final double STEP = 2;

  final int count;

  /** Primitives in the order of leaves, counted from the first bounded one. */
  final int[] order;

  /** Boxes of primitives in that order, six floats each, rounded outward. */
  private final float[] boxes;

  /** Boxes of the two children of every node, twelve floats each. */
  final float[] childBoxes;

  /** The two children of every node: a node number, or a packed leaf. */
  final int[] children;

  /** Whether a node number is in use. */
  final boolean[] used;

  BvhBuilder(Primitives primitives, double margin) {
    boxes = Boxes.around(primitives, margin);
    count = boxes.length / 6;
    order = new int[count];
    for (int i = 0; i < count; i++) {
      order[i] = i;
    }
    int nodes = Math.max(1, count - 1);
    childBoxes = new float[12 * nodes];
    children = new int[2 * nodes];
    used = new boolean[nodes];
  }

  /** Builds the tree and returns its root: node 0, or a leaf for a few primitives. */
  int build() {
    return new Subtree(0, count, 0, 0, new float[6], 0).invoke();
  }

  /** A range of primitives under a node number, and where its parent wants its box. */
  private final class Subtree extends RecursiveTask<Integer> {

    private static final long serialVersionUID = 1;

    private final int start;
    private final int end;
    private final int node;
    private final int depth;
    private final transient float[] boxOut;
    private final int boxAt;

    Subtree(int start, int end, int node, int depth, float[] boxOut, int boxAt) {
      this.start = start;
      this.end = end;
      this.node = node;
      this.depth = depth;
      this.boxOut = boxOut;
      this.boxAt = boxAt;
    }

    @Override
    protected Integer compute() {
      return build(new Binning());
    }

    /** Builds the subtree and returns what its parent has for a child. */
    private int build(Binning binning) {
      int size = end - start;
      binning.examine(boxes, start, end);
      System.arraycopy(binning.box, 0, boxOut, boxAt, 6);
      if (size <= MAX_LEAF) {
        double area = Binning.area(binning.box, 0);
        if (!(STEP * area + binning.cost < size * area)) {
          return Bvh.leaf(start, size);
        }
      }
      used[node] = true;
      boolean byArea = binning.axis >= 0 && depth < SAH_DEPTH;
      int middle = byArea ? partition(binning) : halve(binning.widestAxis());
      Subtree left = new Subtree(start, middle, node + 1, depth + 1, childBoxes, 12 * node);
      Subtree right =
          new Subtree(middle, end, node + middle - start, depth + 1, childBoxes, 12 * node + 6);
      if (size >= PARALLEL) {
        left.fork();
        children[2 * node + 1] = right.build(binning);
        children[2 * node] = left.join();
      } else {
        children[2 * node] = left.build(binning);
        children[2 * node + 1] = right.build(binning);
      }
      return node;
    }

    /** Moves the first side of the best division to the front; returns where the second begins. */
    private int partition(Binning binning) {
      int i = start;
      int j = end - 1;
      while (i <= j) {
        if (binning.isFirst(boxes, i)) {
          i++;
        } else {
          swap(i, j--);
        }
      }
      return i;
    }

    /** Halves the range by count along an axis, if any (Hoare's selection). */
    private int halve(int axis) {
      int middle = (start + end) >>> 1;
      int low = start;
      int high = axis < 0 ? start : end - 1;
      while (low < high) {
        float pivot = Binning.centroid(boxes, (low + high) >>> 1, axis);
        int i = low;
        int j = high;
        while (i <= j) {
          while (Binning.centroid(boxes, i, axis) < pivot) {
            i++;
          }
          while (Binning.centroid(boxes, j, axis) > pivot) {
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
          break;
        }
      }
      return middle;
    }
  }

  private void swap(int i, int j) {
    int o = order[i];
    order[i] = order[j];
    order[j] = o;
    for (int k = 0; k < 6; k++) {
      float b = boxes[6 * i + k];
      boxes[6 * i + k] = boxes[6 * j + k];
      boxes[6 * j + k] = b;
    }
  }
}
