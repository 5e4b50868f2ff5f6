package glint.accel;

/**
 * Finds where to divide a range of boxes by the surface area heuristic over bins; scratch, owned by
 * one building task.
 *
 * <p>Source: I. Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007.
 */
final class Binning {

  private static final int BINS = 16;

  /** The box around the range, six floats. */
  final float[] box = new float[6];

  /** The axis of the best division, or -1 if all centroids coincide. */
  int axis;

  /** The cost of the best division: areas of both sides times their counts. */
  double cost;

  private int bestBin;
  private int bins;
  private final float[] least = new float[3];
  private final float[] scale = new float[3];
  private final float[] binBoxes = new float[3 * BINS * 6];
  private final int[] binCounts = new int[3 * BINS];
  private final double[] behindCost = new double[BINS];
  private final float[] sum = new float[6];

  /** Looks at the boxes of a range and finds the best division. */
  void examine(float[] boxes, int start, int end) {
    bins = Math.min(BINS, end - start + 2);
    measure(boxes, start, end);
    fill(boxes, start, end);
    axis = -1;
    cost = Double.POSITIVE_INFINITY;
    for (int a = 0; a < 3; a++) {
      if (scale[a] > 0) {
        sweep(a, end - start);
      }
    }
  }

  /** Returns whether a box lies on the first side of the best division. */
  boolean isFirst(float[] boxes, int i) {
    return bin(centroid(boxes, i, axis), axis) <= bestBin;
  }

  /** Returns the axis along which centroids spread most, or -1 if they all coincide. */
  int widestAxis() {
    int widest = -1;
    for (int a = 0; a < 3; a++) {
      if (scale[a] > 0 && (widest < 0 || scale[a] < scale[widest])) {
        widest = a;
      }
    }
    return widest;
  }

  /** Returns the middle of a box, halved first so that it does not overflow. */
  static float centroid(float[] boxes, int i, int a) {
    return 0.5f * boxes[6 * i + a] + 0.5f * boxes[6 * i + 3 + a];
  }

  /** Returns half the surface of a box; in doubles, since floats would overflow. */
  static double area(float[] box, int at) {
    double x = (double) box[at + 3] - box[at];
    double y = (double) box[at + 4] - box[at + 1];
    double z = (double) box[at + 5] - box[at + 2];
    return x * y + y * z + z * x;
  }

  /** Finds the box around the range, and the extent of its centroids. */
  private void measure(float[] boxes, int start, int end) {
    clear(box, 0);
    for (int a = 0; a < 3; a++) {
      float low = Float.POSITIVE_INFINITY;
      float high = Float.NEGATIVE_INFINITY;
      for (int i = start; i < end; i++) {
        float c = centroid(boxes, i, a);
        low = c < low ? c : low;
        high = c > high ? c : high;
      }
      least[a] = low;
      float perUnit = bins / (high - low);
      scale[a] = perUnit < Float.POSITIVE_INFINITY ? perUnit : 0;
    }
    for (int i = start; i < end; i++) {
      grow(box, 0, boxes, 6 * i);
    }
  }

  private void fill(float[] boxes, int start, int end) {
    for (int a = 0; a < 3; a++) {
      for (int b = 0; b < bins; b++) {
        clear(binBoxes, 6 * (BINS * a + b));
        binCounts[BINS * a + b] = 0;
      }
    }
    for (int i = start; i < end; i++) {
      for (int a = 0; a < 3; a++) {
        int b = BINS * a + bin(centroid(boxes, i, a), a);
        binCounts[b]++;
        grow(binBoxes, 6 * b, boxes, 6 * i);
      }
    }
  }

  /** Tries the borders between the bins of an axis. */
  private void sweep(int a, int count) {
    clear(sum, 0);
    int behind = 0;
    for (int b = bins - 1; b > 0; b--) {
      grow(sum, 0, binBoxes, 6 * (BINS * a + b));
      behind += binCounts[BINS * a + b];
      behindCost[b] = behind == 0 ? 0 : behind * area(sum, 0);
    }
    clear(sum, 0);
    int before = 0;
    for (int b = 0; b < bins - 1; b++) {
      grow(sum, 0, binBoxes, 6 * (BINS * a + b));
      before += binCounts[BINS * a + b];
      if (before > 0 && before < count) {
        double candidate = before * area(sum, 0) + behindCost[b + 1];
        if (candidate < cost) {
          cost = candidate;
          axis = a;
          bestBin = b;
        }
      }
    }
  }

  private int bin(float centroid, int a) {
    int b = (int) ((centroid - least[a]) * scale[a]);
    return b < 0 ? 0 : b < bins ? b : bins - 1;
  }

  private static void clear(float[] box, int at) {
    box[at] = Float.POSITIVE_INFINITY;
    box[at + 1] = Float.POSITIVE_INFINITY;
    box[at + 2] = Float.POSITIVE_INFINITY;
    box[at + 3] = Float.NEGATIVE_INFINITY;
    box[at + 4] = Float.NEGATIVE_INFINITY;
    box[at + 5] = Float.NEGATIVE_INFINITY;
  }

  private static void grow(float[] box, int at, float[] other, int from) {
    box[at] = min(box[at], other[from]);
    box[at + 1] = min(box[at + 1], other[from + 1]);
    box[at + 2] = min(box[at + 2], other[from + 2]);
    box[at + 3] = max(box[at + 3], other[from + 3]);
    box[at + 4] = max(box[at + 4], other[from + 4]);
    box[at + 5] = max(box[at + 5], other[from + 5]);
  }

  private static float min(float a, float b) {
    return b < a ? b : a;
  }

  private static float max(float a, float b) {
    return b > a ? b : a;
  }
}
