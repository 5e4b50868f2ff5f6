package glint.accel;

import glint.math.Vector3d;
import java.util.Arrays;
import java.util.Comparator;
import java.util.PriorityQueue;

/**
 * Subtrees of a large tree that together hold all of it, none of them much larger than others;
 * immutable.
 */
public final class Parts {

  /** So many are seen one by one in a {@link Pencil}. */
  private static final int MOST = 4096;

  private final int[] nodes;

  /** Where the box of each begins among the nodes of the tree. */
  private final int[] places;

  /** The largest absolute coordinate of what they hold. */
  private final double size;

  private Parts(Bvh tree, int[] places) {
    nodes = tree.nodes;
    size = tree.size;
    this.places = places;
  }

  /** Finds those of a tree that has a node. */
  public static Parts of(Bvh tree) {
    return of(tree, MOST);
  }

  /** Divides what has the largest box until there are so many, at least two. */
  static Parts of(Bvh tree, int most) {
    int[] nodes = tree.nodes;
    PriorityQueue<Integer> whole =
        new PriorityQueue<>(Comparator.comparingDouble((Integer place) -> -area(nodes, place)));
    int[] places = new int[most];
    int count = 0;
    whole.add(0);
    whole.add(Bvh.BOX);
    while (!whole.isEmpty() && count + whole.size() < most) {
      int place = whole.remove();
      int child = Bvh.child(nodes, place);
      if (child < 0) {
        places[count++] = place;
      } else {
        whole.add(child);
        whole.add(child + Bvh.BOX);
      }
    }
    for (int place : whole) {
      places[count++] = place;
    }
    return new Parts(tree, Arrays.copyOf(places, count));
  }

  /** Returns half of a box's area. */
  private static double area(int[] nodes, int place) {
    double x = plane(nodes, place + 3) - plane(nodes, place);
    double y = plane(nodes, place + 4) - plane(nodes, place + 1);
    double z = plane(nodes, place + 5) - plane(nodes, place + 2);
    return x * y + y * z + z * x;
  }

  private static double plane(int[] nodes, int at) {
    return Float.intBitsToFloat(nodes[at]);
  }

  /** Returns the largest absolute coordinate of what they hold. */
  double size() {
    return size;
  }

  /** Writes the box that begins at a place: least corner, then greatest. */
  void bounds(int place, double[] out) {
    for (int j = 0; j < Bvh.BOX; j++) {
      out[j] = plane(nodes, place + j);
    }
  }

  /**
   * Returns where the boxes begin, in the order in which rays meet them, more or less.
   *
   * @param from where rays come from, or else the direction in which they lead
   */
  int[] sorted(Vector3d from, boolean direction) {
    long[] keys = new long[places.length];
    for (int i = 0; i < keys.length; i++) {
      keys[i] = key(places[i], from, direction) << 32 | i;
    }
    Arrays.sort(keys);
    int[] sorted = new int[keys.length];
    for (int i = 0; i < keys.length; i++) {
      sorted[i] = places[(int) keys[i]];
    }
    return sorted;
  }

  /** A number that grows with the distance of a box, or with how far in a direction it lies. */
  private long key(int place, Vector3d from, boolean direction) {
    double[] middle = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      middle[axis] = plane(nodes, place + axis) / 2 + plane(nodes, place + 3 + axis) / 2;
    }
    Vector3d at = new Vector3d(middle[0], middle[1], middle[2]);
    double far = direction ? from.dot(at) : at.minus(from).length();
    int bits = Float.floatToIntBits((float) far);
    return bits ^ bits >> 31 & Integer.MAX_VALUE;
  }
}
