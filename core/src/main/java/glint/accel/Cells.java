package glint.accel;

import java.util.Arrays;
import java.util.Comparator;

/**
 * Grids of cells over rectangles, with a list for each cell of the few boxes that are seen in it;
 * immutable.
 *
 * <p>Every face has a grid of its own. A place on a face has two coordinates, v and w.
 */
final class Cells {

  /** In place of a list: more than are worth one. */
  static final int MANY = -1;

  /** The list of a place where nothing is seen. */
  private static final int NOTHING = 0;

  /** Lists are at most this long. */
  private static final int LONGEST = 15;

  // No fewer and no more cells stand side by side.
  private static final int LEAST_SIDE = 32;
  private static final int MOST_SIDE = 128;

  /** A list is where it starts among all, and in its lowest bits how long it is. */
  private static final int LENGTH_BITS = 4;

  /**
   * The rectangle of each face in six numbers: the least and the greatest v, how many cells there
   * are per unit of it, and the same of w.
   */
  private final double[] frames;

  /** How many cells stand side by side. */
  private final int side;

  private final int[][] lists;
  private final int[] boxes;

  /** How near each of those may be to where all are seen from, less what roundings add. */
  private final float[] depths;

  /**
   * Lists boxes by their rectangles.
   *
   * @param seen by face four numbers for each box, its least and greatest v, its least and greatest
   *     w; the least above the greatest where it is not seen
   * @param near by face a number for each box: how far, at least, it is away
   */
  Cells(double[][] seen, double[][] near) {
    side = side(seen[0].length / 4);
    frames = new double[6 * seen.length];
    lists = new int[seen.length][];
    int all = 0;
    for (int face = 0; face < seen.length; face++) {
      frame(6 * face, seen[face], 0);
      frame(6 * face + 3, seen[face], 2);
      lists[face] = count(6 * face, seen[face]);
      all = lay(lists[face], all);
    }
    boxes = new int[all];
    depths = new float[all];
    for (int face = 0; face < seen.length; face++) {
      fill(face, seen[face], near[face]);
    }
  }

  /** Returns how many cells stand side by side: 16 to 64 times as many in all as boxes. */
  private static int side(int boxes) {
    int side = LEAST_SIDE;
    while (side < MOST_SIDE && side * side < 16 * boxes) {
      side *= 2;
    }
    return side;
  }

  /** Finds what all rectangles of a face take up in one coordinate. */
  private void frame(int at, double[] seen, int coordinate) {
    double least = Double.POSITIVE_INFINITY;
    double greatest = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < seen.length; i += 4) {
      if (isSeen(seen, i)) {
        least = Math.min(least, seen[i + coordinate]);
        greatest = Math.max(greatest, seen[i + coordinate + 1]);
      }
    }
    frames[at] = least;
    frames[at + 1] = greatest;
    frames[at + 2] = side / (greatest - least);
  }

  private static boolean isSeen(double[] seen, int i) {
    return seen[i] <= seen[i + 1] && seen[i + 2] <= seen[i + 3];
  }

  /** Counts, for each cell of a face, the boxes that are seen in it. */
  private int[] count(int at, double[] seen) {
    int[] counts = new int[frames[at] <= frames[at + 1] ? side * side : 0];
    for (int i = 0; i < seen.length; i += 4) {
      if (isSeen(seen, i)) {
        int last = cell(seen[i + 1], at);
        for (int row = cell(seen[i + 2], at + 3); row <= cell(seen[i + 3], at + 3); row++) {
          for (int column = cell(seen[i], at); column <= last; column++) {
            counts[side * row + column]++;
          }
        }
      }
    }
    return counts;
  }

  /** Turns counts into lists that are empty yet; returns where the next one may start. */
  private int lay(int[] counts, int start) {
    int next = start;
    for (int cell = 0; cell < counts.length; cell++) {
      int count = counts[cell];
      counts[cell] = count > LONGEST ? MANY : next << LENGTH_BITS;
      next += count > LONGEST ? 0 : count;
    }
    return next;
  }

  /** Fills the lists of a face: what is near comes first. */
  private void fill(int face, double[] seen, double[] near) {
    int at = 6 * face;
    Integer[] order = new Integer[near.length];
    Arrays.setAll(order, box -> box);
    Arrays.sort(order, Comparator.comparingDouble(box -> near[box]));
    for (int box : order) {
      int i = 4 * box;
      if (isSeen(seen, i)) {
        float depth = Math.nextDown((float) near[box]);
        int last = cell(seen[i + 1], at);
        for (int row = cell(seen[i + 2], at + 3); row <= cell(seen[i + 3], at + 3); row++) {
          for (int column = cell(seen[i], at); column <= last; column++) {
            add(lists[face], side * row + column, box, depth);
          }
        }
      }
    }
  }

  private void add(int[] of, int cell, int box, float depth) {
    int list = of[cell];
    if (list != MANY) {
      int place = start(list) + length(list);
      boxes[place] = box;
      depths[place] = depth;
      of[cell] = list + 1;
    }
  }

  /** Which cell of a row or column a coordinate lies in; a greater one lies in no lower cell. */
  private int cell(double v, int at) {
    return Math.min((int) ((v - frames[at]) * frames[at + 2]), side - 1);
  }

  /** Returns the list for a place on a face, or {@link #MANY}. */
  int list(int face, double v, double w) {
    int at = 6 * face;
    boolean within = v >= frames[at] && v <= frames[at + 1];
    if (!(within && w >= frames[at + 3] && w <= frames[at + 4])) {
      return NOTHING;
    }
    return lists[face][side * cell(w, at + 3) + cell(v, at)];
  }

  /** Returns where a list starts. */
  static int start(int list) {
    return list >> LENGTH_BITS;
  }

  /** Returns how long a list is. */
  static int length(int list) {
    return list & (1 << LENGTH_BITS) - 1;
  }

  /** Returns how far, at least, the box at a place in the lists is away; it grows along a list. */
  float depth(int place) {
    return depths[place];
  }

  /** Returns the number of the box at a place in the lists. */
  int box(int place) {
    return boxes[place];
  }
}
