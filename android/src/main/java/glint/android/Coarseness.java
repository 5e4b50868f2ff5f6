package glint.android;

/** How coarse pictures must be to follow a hand. */
final class Coarseness {

  /** A picture in less than this is soon enough. */
  private static final double SOON = 1.0 / 15;

  /** A picture in less than this may be finer: one of four times as many pixels is soon enough. */
  private static final double VERY_SOON = SOON / 5;

  private static final int FINEST = 2;
  private static final int COARSEST = 16;

  private int factor = 8;

  /** Returns the pixels of a side that has so many when the picture is not coarse. */
  int of(int side) {
    return Math.max(1, side / factor);
  }

  /** Learns how long a picture took, in seconds. */
  void learn(double seconds) {
    if (seconds > SOON) {
      factor = Math.min(COARSEST, 2 * factor);
    } else if (seconds < VERY_SOON) {
      factor = Math.max(FINEST, factor / 2);
    }
  }
}
