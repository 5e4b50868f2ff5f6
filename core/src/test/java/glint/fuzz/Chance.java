package glint.fuzz;

import java.util.List;

/**
 * Random numbers, the same on every machine for the same seed.
 *
 * <p>SplitMix64 (Steele, Lea, Flood 2014), whose streams of neighbouring seeds are independent.
 */
final class Chance {

  private long state;

  Chance(long seed) {
    state = mix(seed);
  }

  long bits() {
    state += 0x9e3779b97f4a7c15L;
    return mix(state);
  }

  /** Returns a whole number from 0 to n - 1. */
  int below(int n) {
    return (int) ((bits() >>> 32) * n >>> 32);
  }

  /** Returns a whole number of a range, both ends included. */
  int between(int least, int greatest) {
    return least + below(greatest - least + 1);
  }

  boolean oneIn(int n) {
    return below(n) == 0;
  }

  /** Returns a number from 0 to below 1. */
  double unit() {
    return (bits() >>> 11) * 0x1p-53;
  }

  double sign() {
    return bits() < 0 ? -1 : 1;
  }

  double of(double... choices) {
    return choices[below(choices.length)];
  }

  <T> T of(List<T> choices) {
    return choices.get(below(choices.size()));
  }

  private static long mix(long value) {
    long z = value;
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }
}
