package glint.accel;

import glint.geometry.Primitives;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * Boxes around the bounded primitives of a scene, for those that are not worth a tree; immutable.
 */
public final class Boxes {

  /** Boxes are this share of the largest coordinate wider than their primitives. */
  static final double MARGIN = 0x1p-40;

  /** What they are around. */
  final Primitives primitives;

  /** The largest absolute coordinate of the primitives' boxes. */
  final double size;

  /**
   * For each bounded primitive the bits of six floats, the least and the greatest corner, rounded
   * outward; the smallest box first.
   */
  final int[] bits;

  /** The slots of the primitives, in the order of their boxes. */
  final int[] slots;

  private Boxes(Primitives primitives) {
    this.primitives = primitives;
    size = largestCoordinate(primitives);
    float[] boxes = around(primitives, size * MARGIN);
    slots = smallestFirst(boxes);
    bits = new int[boxes.length];
    for (int i = 0; i < slots.length; i++) {
      for (int j = 0; j < 6; j++) {
        bits[6 * i + j] = Float.floatToIntBits(boxes[6 * slots[i] + j]);
      }
      slots[i] += primitives.unbounded();
    }
  }

  /**
   * Returns the numbers of boxes in the order of their areas: what a ray meets that is small lies
   * before what is large more often than behind.
   */
  private static int[] smallestFirst(float[] boxes) {
    return IntStream.range(0, boxes.length / 6)
        .boxed()
        .sorted(Comparator.comparingDouble(i -> area(boxes, 6 * i)))
        .mapToInt(Integer::intValue)
        .toArray();
  }

  private static double area(float[] boxes, int at) {
    double x = (double) boxes[at + 3] - boxes[at];
    double y = (double) boxes[at + 4] - boxes[at + 1];
    double z = (double) boxes[at + 5] - boxes[at + 2];
    return x * y + y * z + z * x;
  }

  /** Finds the boxes. */
  public static Boxes around(Primitives primitives) {
    return new Boxes(primitives);
  }

  /** Returns the largest absolute coordinate of the boxes of bounded primitives. */
  static double largestCoordinate(Primitives primitives) {
    double[] box = new double[6];
    double largest = 0;
    for (int slot = primitives.unbounded(); slot < primitives.count(); slot++) {
      primitives.bounds(slot, box);
      for (double v : box) {
        largest = Math.max(largest, Math.abs(v));
      }
    }
    return largest;
  }

  /** Returns the boxes, wider by a margin, six floats each. */
  static float[] around(Primitives primitives, double margin) {
    int first = primitives.unbounded();
    int count = primitives.count() - first;
    float[] boxes = new float[6 * count];
    double[] box = new double[6];
    for (int i = 0; i < count; i++) {
      primitives.bounds(first + i, box);
      for (int axis = 0; axis < 3; axis++) {
        boxes[6 * i + axis] = roundDown(box[axis] - margin);
        boxes[6 * i + 3 + axis] = roundUp(box[3 + axis] + margin);
      }
    }
    return boxes;
  }

  private static float roundDown(double v) {
    float f = (float) v;
    return f > v ? Math.nextDown(f) : f;
  }

  private static float roundUp(double v) {
    float f = (float) v;
    return f < v ? Math.nextUp(f) : f;
  }
}
