package glint.desktop.window;

import glint.image.Image;
import java.awt.image.BufferedImage;
import java.util.Optional;

/**
 * How far a render has come; immutable but for the linear image, which grows.
 *
 * @param picture what there is to show; absent before the first rays
 * @param linear the same in linear light; absent like the picture
 * @param done the part of the work that is done, 0 to 1
 * @param rays rays traced so far
 * @param seconds time since the render was chosen, pauses left out
 * @param error what is claimed for the picture, in levels; infinite while unknown
 * @param findings what else is known; absent while preparing
 * @param message what went wrong; empty if nothing did
 */
record Snapshot(
    State state,
    Optional<BufferedImage> picture,
    Optional<Image> linear,
    double done,
    long rays,
    double seconds,
    double error,
    Optional<Findings> findings,
    String message) {

  /** Where a render stands. */
  enum State {
    PREPARING("preparing"),
    RENDERING("rendering"),
    PAUSED("paused"),
    DONE("done"),
    STOPPED("stopped"),
    FAILED("failed");

    final String words;

    State(String words) {
      this.words = words;
    }

    /** Returns whether nothing more will come. */
    boolean isOver() {
      return ordinal() >= DONE.ordinal();
    }
  }
}
