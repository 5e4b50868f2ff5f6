package glint.io;

import java.util.Arrays;

/**
 * Numbers that come one by one, kept in blocks, so that there is never a second copy of them all.
 */
final class Doubles {

  private static final int SHIFT = 14;
  private static final int BLOCK = 1 << SHIFT;

  private double[][] blocks = new double[16][];
  private int size;

  void add(double v) {
    int inBlock = size & BLOCK - 1;
    if (inBlock == 0) {
      addBlock();
    }
    blocks[size++ >> SHIFT][inBlock] = v;
  }

  private void addBlock() {
    int count = size >> SHIFT;
    if (size == Integer.MAX_VALUE - BLOCK + 1) {
      throw new OutOfMemoryError("a model of too many points");
    }
    if (count == blocks.length) {
      blocks = Arrays.copyOf(blocks, 2 * count);
    }
    blocks[count] = new double[BLOCK];
  }

  double get(int i) {
    return blocks[i >> SHIFT][i & BLOCK - 1];
  }

  int size() {
    return size;
  }

  /** Returns all numbers in one array; ends the use of this. */
  double[] toArray() {
    double[] all = new double[size];
    for (int at = 0; at < size; at += BLOCK) {
      System.arraycopy(blocks[at >> SHIFT], 0, all, at, Math.min(BLOCK, size - at));
      blocks[at >> SHIFT] = null;
    }
    return all;
  }
}
