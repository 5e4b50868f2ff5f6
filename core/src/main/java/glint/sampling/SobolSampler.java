package glint.sampling;

/**
 * The places of a pixel's samples, and the numbers that decide all that a sample leaves to chance:
 * two-dimensional Owen-scrambled Sobol sequences.
 *
 * <p>A number is a function of pixel, sample number, seed and dimension alone, so nothing depends
 * on tiles or threads. Of every pair of dimensions any first 2^k samples are a (0, k, 2)-net: every
 * elementary interval holds its share. Pairs are made independent of each other by shuffling the
 * order of samples, which keeps that. Source: B. Burley, Practical Hash-based Owen Scrambling, JCGT
 * 9(4), 2020, with the bit mixer of N. Vegdahl.
 */
public final class SobolSampler {

  private final long seed;
  private long pixel;
  private int index;
  private boolean centred = true;
  private boolean drawn;

  /** The place of the last sample within its pixel, 0 to 1 from the left and from the top. */
  public double x;

  public double y;

  /** The last pair that was drawn, each between 0 and 1. */
  public double u;

  public double v;

  /** Makes a sampler for one randomisation. */
  public SobolSampler(long seed) {
    this.seed = mix(seed);
  }

  /** Turns to a pixel. */
  public void pixel(int column, int row) {
    pixel = mix(seed ^ ((long) row << 32 | column));
  }

  /** Turns to the sample with a number from 0 and places it into {@link #x} and {@link #y}. */
  public void sample(int number) {
    index = number;
    centred = false;
    drawn = false;
    // Reversing the bits of the index gives the first dimension; scrambling reverses them again.
    x = unit(scramble(number, (int) pixel));
    y = unit(scramble(second(number), (int) (pixel >>> 32)));
  }

  /**
   * Turns to a sample that leaves nothing to chance: its place and all its pairs are the middle.
   */
  public void centre() {
    centred = true;
    drawn = false;
    x = 0.5;
    y = 0.5;
  }

  /** Returns whether this sample leaves nothing to chance. */
  public boolean isCentred() {
    return centred;
  }

  /** Returns whether the sample has needed more numbers than its place. */
  public boolean hasDrawn() {
    return drawn;
  }

  /** Draws the sample's pair {@link #u}, {@link #v} of two dimensions of one's own choice. */
  public void draw(long dimensions) {
    drawn = true;
    if (centred) {
      u = 0.5;
      v = 0.5;
      return;
    }
    long keys = mix(pixel ^ dimensions);
    int shuffled = scramble(Integer.reverse(index), (int) keys);
    keys = mix(keys);
    u = unit(scramble(shuffled, (int) keys));
    v = unit(scramble(second(shuffled), (int) (keys >>> 32)));
  }

  /**
   * Returns the second Sobol dimension with its bits reversed: the Pascal matrix modulo 2 times an
   * index. Entry (i, j) is 1 where the bits of i are among those of j (Lucas), so that bits are
   * summed over supersets, one bit of their places after the other.
   */
  private static int second(int index) {
    int bits = index;
    bits ^= bits >>> 16;
    bits ^= bits >>> 8 & 0x00ff00ff;
    bits ^= bits >>> 4 & 0x0f0f0f0f;
    bits ^= bits >>> 2 & 0x33333333;
    bits ^= bits >>> 1 & 0x55555555;
    return bits;
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
  public static long mix(long value) {
    long z = value + 0x9e3779b97f4a7c15L;
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }
}
