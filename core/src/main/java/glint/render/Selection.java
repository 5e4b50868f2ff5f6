package glint.render;

import java.util.Arrays;

/** Numbers from 0 that are chosen one by one, each once, in the order of their choice. */
final class Selection {

  private boolean[] isChosen = new boolean[1024];
  private int[] numbers = new int[1024];
  private int size;

  /** Chooses a number, if it is not chosen yet. */
  void add(int number) {
    if (number >= isChosen.length) {
      isChosen = Arrays.copyOf(isChosen, Math.max(number + 1, 2 * isChosen.length));
    }
    if (isChosen[number]) {
      return;
    }
    isChosen[number] = true;
    if (size == numbers.length) {
      numbers = Arrays.copyOf(numbers, 2 * size);
    }
    numbers[size++] = number;
  }

  boolean isEmpty() {
    return size == 0;
  }

  /** Returns the numbers chosen; they stay chosen. */
  int[] list() {
    return Arrays.copyOf(numbers, size);
  }

  /** Returns the numbers chosen, and begins to choose anew. */
  int[] take() {
    int[] all = list();
    for (int each : all) {
      isChosen[each] = false;
    }
    size = 0;
    return all;
  }
}
