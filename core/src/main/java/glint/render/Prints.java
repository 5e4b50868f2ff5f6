package glint.render;

import glint.color.Rgb;
import glint.trace.Print;
import java.util.Arrays;

/** What images show at the corners of pixels: flat arrays. */
final class Prints {

  /**
   * Numbers of a corner: where in its image what it meets first lies, in pixels of that; radiance
   * for every unit of the colour there; and the radiance that the colour does not make.
   */
  static final int NUMBERS = 8;

  static final int GAIN = 2;
  static final int REST = 5;

  /** From half a pixel of an image on, a side of a pixel is as likely to have a kink as not. */
  private static final double LEAP = 0.5;

  /** Those numbers, by corner; NaN where what is met first shows no image. */
  final double[] seen;

  /** What the ray would see, in levels, if the image had one colour all over. */
  final float[] plain;

  /** Where in other images the ray looked, in their pixels. */
  private final float[] beyond;

  Prints(int count) {
    seen = new double[NUMBERS * count];
    plain = new float[3 * count];
    beyond = new float[2 * count];
  }

  /** Notes what the last ray of a probe saw, as that of a corner. */
  void note(int corner, Probe probe, LevelScale scale, float[] levels) {
    beyond[2 * corner] = (float) probe.imageX();
    beyond[2 * corner + 1] = (float) probe.imageY();
    Print print = probe.print();
    int at = NUMBERS * corner;
    if (!print.found) {
      fill(corner, levels);
      return;
    }
    seen[at] = print.x;
    seen[at + 1] = print.y;
    seen[at + GAIN] = print.gainR;
    seen[at + GAIN + 1] = print.gainG;
    seen[at + GAIN + 2] = print.gainB;
    seen[at + REST] = probe.r() - print.r;
    seen[at + REST + 1] = probe.g() - print.g;
    seen[at + REST + 2] = probe.b() - print.b;
    Rgb mean = print.mean;
    plain[3 * corner] = (float) scale.level(seen[at + REST] + print.gainR * mean.r());
    plain[3 * corner + 1] = (float) scale.level(seen[at + REST + 1] + print.gainG * mean.g());
    plain[3 * corner + 2] = (float) scale.level(seen[at + REST + 2] + print.gainB * mean.b());
  }

  /** Notes that no image is seen at a corner. */
  void fill(int corner, float[] levels) {
    Arrays.fill(seen, NUMBERS * corner, NUMBERS * corner + NUMBERS, Double.NaN);
    System.arraycopy(levels, 3 * corner, plain, 3 * corner, 3);
  }

  /** Returns whether what a corner meets first shows an image. */
  boolean has(int corner) {
    return !Double.isNaN(seen[NUMBERS * corner]);
  }

  /** Returns whether there is much of the image that they meet first between two corners. */
  boolean leaps(int a, int b) {
    return has(a)
        && !(Math.abs(seen[NUMBERS * a] - seen[NUMBERS * b]) <= LEAP
            && Math.abs(seen[NUMBERS * a + 1] - seen[NUMBERS * b + 1]) <= LEAP);
  }

  /** Returns whether there is much of other images between two corners. */
  boolean leapsBeyond(int a, int b) {
    return !(Math.abs(beyond[2 * a] - beyond[2 * b]) <= LEAP
        && Math.abs(beyond[2 * a + 1] - beyond[2 * b + 1]) <= LEAP);
  }
}
