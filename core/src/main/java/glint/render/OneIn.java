package glint.render;

/**
 * Takes one in so many hashes: the multiples of a number, which are told without a division
 * (Warren, Hacker's Delight, 2nd edition, 10-17); immutable.
 */
final class OneIn {

  private final long inverse;
  private final int shift;
  private final long most;

  /**
   * Takes one in so many.
   *
   * @param number at least 1
   */
  OneIn(int number) {
    shift = Integer.numberOfTrailingZeros(number);
    long odd = number >> shift;
    long x = odd;
    for (int bits = 3; bits < Long.SIZE; bits *= 2) {
      x *= 2 - odd * x;
    }
    inverse = x;
    most = Long.divideUnsigned(-1, number);
  }

  /** Returns whether a hash, unsigned, is a multiple of the number. */
  boolean takes(long hash) {
    long quotient = Long.rotateRight(hash * inverse, shift);
    return Long.compareUnsigned(quotient, most) <= 0;
  }
}
