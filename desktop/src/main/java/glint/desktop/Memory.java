package glint.desktop;

import java.util.Locale;

/** What an image needs of Java's memory. */
final class Memory {

  /** Three doubles. */
  private static final long BYTES_PER_PIXEL = 24;

  /** Eight-bit codes, packed into an int, a bound on what was not followed, and two moves. */
  private static final long CODE_BYTES_PER_PIXEL = 20;

  /** What is known of every pixel while it is refined: corners, edges, sums, estimates. */
  private static final long REFINED_BYTES_PER_PIXEL = 92;

  private Memory() {}

  /**
   * Checks that an image and its extra images can be held.
   *
   * @throws RunException if Java may not use as much memory as they need
   */
  static void check(int width, int height, int extraImages) throws RunException {
    check(width, height, extraImages, 0);
  }

  /** Checks the same for an image that is refined to an error. */
  static void checkRefined(int width, int height, int extraImages) throws RunException {
    check(width, height, extraImages, REFINED_BYTES_PER_PIXEL);
  }

  private static void check(int width, int height, int extraImages, long more) throws RunException {
    long pixels = (long) width * height;
    long perPixel = BYTES_PER_PIXEL * (1 + extraImages) + CODE_BYTES_PER_PIXEL + more;
    long needed = pixels * perPixel;
    long available = Runtime.getRuntime().maxMemory();
    if (needed > available) {
      throw new RunException(
          String.format(
              Locale.ROOT,
              "an image of %dx%d%s needs %d MiB, but Java may use %d MiB; %s",
              width,
              height,
              extraImages == 0 ? "" : " and its " + extraImages + " extra images",
              roundedUp(needed),
              available >> 20,
              advice(needed)));
    }
  }

  /** Says, when all memory is used up, how much that was and how to go on. */
  static String usedUp() {
    long available = Runtime.getRuntime().maxMemory();
    return String.format(
        Locale.ROOT,
        "image and scene need more than the %d MiB of memory that Java may use; %s",
        available >> 20,
        advice(available));
  }

  private static String advice(long needed) {
    long gibibytes = (needed >> 30) + (needed >> 31) + 1;
    return "make the image smaller (--size), or allow more: JAVA_OPTS=-Xmx" + gibibytes + "g";
  }

  /** Returns mebibytes. */
  private static long roundedUp(long bytes) {
    return (bytes >> 20) + 1;
  }
}
