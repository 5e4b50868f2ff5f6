package glint.desktop;

import java.util.Locale;

/** What an image needs of Java's memory. */
final class Memory {

  /** Three doubles. */
  private static final long BYTES_PER_PIXEL = 24;

  /** Eight-bit codes, packed into an int. */
  private static final long CODE_BYTES_PER_PIXEL = 4;

  private Memory() {}

  /**
   * Checks that an image and its extra images can be held.
   *
   * @throws RunException if Java may not use as much memory as they need
   */
  static void check(int width, int height, int extraImages) throws RunException {
    long pixels = (long) width * height;
    long needed = pixels * (BYTES_PER_PIXEL * (1 + extraImages) + CODE_BYTES_PER_PIXEL);
    long available = Runtime.getRuntime().maxMemory();
    if (needed > available) {
      throw new RunException(
          String.format(
              Locale.ROOT,
              "an image of %dx%d%s needs %d MiB, but Java may use %d MiB; %s",
              width,
              height,
              extraImages == 0 ? "" : " and its " + extraImages + " extra images",
              mebibytes(needed),
              mebibytes(available),
              advice(needed)));
    }
  }

  /** Says how to go on when all memory is used up. */
  static String advice() {
    return advice(Runtime.getRuntime().maxMemory());
  }

  private static String advice(long needed) {
    long gibibytes = (needed >> 30) + (needed >> 31) + 1;
    return "make the image smaller (--size), or allow more: JAVA_OPTS=-Xmx" + gibibytes + "g";
  }

  private static long mebibytes(long bytes) {
    return (bytes >> 20) + 1;
  }
}
