package glint.render;

/**
 * The places of a pixel's samples: a two-dimensional Owen-scrambled Sobol sequence per pixel.
 *
 * <p>A sample is a function of pixel, sample number and seed alone, so nothing depends on tiles or
 * threads. Any first 2^k of them are a (0, k, 2)-net: every elementary interval holds its share.
 * Source: B. Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020, with the bit mixer of
 * N. Vegdahl.
 */
public final class SobolSampler {

  /** Direction numbers of the second Sobol dimension: the Pascal matrix modulo 2. */
  private static final int[] SECOND = new int[32];

  static {
    int column = 0x80000000;
    for (int i = 0; i < 32; i++) {
      SECOND[i] = column;
      column ^= column >>> 1;
    }
  }

  private final long seed;
  private int scrambleX;
  private int scrambleY;

  /** The place of the last sample within its pixel, 0 to 1 from the left and from the top. */
  public double x;

  public double y;

  /** Makes a sampler for one randomisation. */
  public SobolSampler(long seed) {
    this.seed = seed;
  }

  /** Turns to a pixel. */
  public void pixel(int column, int row) {
    long bits = mix(mix(seed) ^ ((long) row << 32 | column));
    scrambleX = (int) bits;
    scrambleY = (int) (bits >>> 32);
  }

  /** Places the sample with a number from 0 into {@link #x} and {@link #y}. */
  public void sample(int index) {
    int second = 0;
    for (int rest = index, i = 0; rest != 0; rest >>>= 1, i++) {
      if ((rest & 1) != 0) {
        second ^= SECOND[i];
      }
    }
    // Reversing the bits of the index gives the first dimension; scrambling reverses them again.
    x = unit(scramble(index, scrambleX));
    y = unit(scramble(Integer.reverse(second), scrambleY));
  }

  /** Owen-scrambles a point whose bits are given in reversed order. */
  private static int scramble(int reversed, int key) {
    int v = reversed;
    v ^= v * 0x3d20adea;
    v += key;
    v *= (key >>> 16) | 1;
    v ^= v * 0x05526c56;
    v ^= v * 0x53a22864;
    return Integer.reverse(v);
  }

  /** The middle of the interval of 2^-32 that 32 bits stand for. */
  private static double unit(int bits) {
    return ((bits & 0xffffffffL) + 0.5) * 0x1p-32;
  }

  /** The finaliser of SplitMix64 (Steele, Lea, Flood 2014). */
  static long mix(long value) {
    long z = value + 0x9e3779b97f4a7c15L;
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }
}
