package glint.io;

import java.util.Arrays;

/**
 * Whole numbers that come one by one, kept in blocks, so that there is never a second copy of them
 * all.
 */
final class Ints {

  private static final int SHIFT = 14;
  private static final int BLOCK = 1 << SHIFT;

  private int[][] blocks = new int[16][];
  private int size;

  void add(int v) {
    int inBlock = size & BLOCK - 1;
    if (inBlock == 0) {
      addBlock();
    }
    blocks[size++ >> SHIFT][inBlock] = v;
  }

  /** Adds one number as often as it takes to have so many. */
  void fill(int most, int v) {
    while (size < most) {
      add(v);
    }
  }

  private void addBlock() {
    int count = size >> SHIFT;
    if (size == Integer.MAX_VALUE - BLOCK + 1) {
      throw new OutOfMemoryError("a model of too many triangles");
    }
    if (count == blocks.length) {
      blocks = Arrays.copyOf(blocks, 2 * count);
    }
    blocks[count] = new int[BLOCK];
  }

  int get(int i) {
    return blocks[i >> SHIFT][i & BLOCK - 1];
  }

  int size() {
    return size;
  }

  /** Returns all numbers in one array; ends the use of this. */
  int[] toArray() {
    int[] all = new int[size];
    for (int at = 0; at < size; at += BLOCK) {
      System.arraycopy(blocks[at >> SHIFT], 0, all, at, Math.min(BLOCK, size - at));
      blocks[at >> SHIFT] = null;
    }
    return all;
  }
}
