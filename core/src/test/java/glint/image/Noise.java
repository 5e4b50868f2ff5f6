package glint.image;

import java.util.Random;

/** Images for tests: any codes, the same ones every time. */
public final class Noise {

  private Noise() {}

  /** Returns an image of a size. */
  public static ByteImage of(int width, int height) {
    byte[] codes = new byte[3 * width * height];
    new Random(31L * width + height).nextBytes(codes);
    return new ByteImage(width, height, codes);
  }
}
