package glint.models.shape;

import glint.math.Vector3d;

/**
 * Smooth noise in space, between −1 and 1: random values at whole numbers, blended by x²(3 − 2x).
 */
public final class Noise {

  private final long seed;

  /** Noise of its own for every seed. */
  public Noise(long seed) {
    this.seed = seed;
  }

  /** Returns a random number from 0 to 1 for a whole one. */
  public double pick(long number) {
    return (value(number, 0, 0) + 1) / 2;
  }

  /** Returns the noise at a point. */
  public double at(Vector3d p) {
    long x = (long) Math.floor(p.x());
    long y = (long) Math.floor(p.y());
    long z = (long) Math.floor(p.z());
    double u = fade(p.x() - x);
    double v = fade(p.y() - y);
    double w = fade(p.z() - z);
    double sum = 0;
    for (int corner = 0; corner < 8; corner++) {
      int i = corner & 1;
      int j = corner >> 1 & 1;
      int k = corner >> 2;
      double weight = (i == 1 ? u : 1 - u) * (j == 1 ? v : 1 - v) * (k == 1 ? w : 1 - w);
      sum += weight * value(x + i, y + j, z + k);
    }
    return sum;
  }

  /** Returns noise of several sizes, each half as large and half as strong as the one before. */
  public double octaves(Vector3d p, int count) {
    double sum = 0;
    double strength = 1;
    for (int i = 0; i < count; i++) {
      sum += strength * at(p.times(1 / strength));
      strength /= 2;
    }
    return sum;
  }

  private static double fade(double x) {
    return x * x * (3 - 2 * x);
  }

  /** Mixes three whole numbers (the last step of SplitMix64, thrice). */
  private double value(long x, long y, long z) {
    long mixed = mix(mix(mix(seed + x) + y) + z);
    return (mixed >> 11) * 0x1p-52;
  }

  private static long mix(long bits) {
    long z = bits + 0x9e3779b97f4a7c15L;
    z = (z ^ z >>> 30) * 0xbf58476d1ce4e5b9L;
    z = (z ^ z >>> 27) * 0x94d049bb133111ebL;
    return z ^ z >>> 31;
  }
}
