package glint.desktop.window;

import glint.image.Image;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;

/**
 * How far a render has come; immutable but for the linear image, which grows.
 *
 * @param picture what there is to show, to be stretched to the size of the image; absent before the
 *     first rays
 * @param linear the same in linear light; absent like the picture, and while the camera moves
 * @param done the part of the work that is done, 0 to 1
 * @param left the seconds that are left, about; infinite if that cannot be told
 * @param rays rays traced so far
 * @param seconds time since the render was chosen, pauses left out, or of this picture alone
 * @param error what is claimed for the picture, in levels; infinite while unknown
 * @param findings what else is known; absent while preparing
 * @param inWork the parts of the image that are worked on
 * @param message what went wrong; empty if nothing did
 */
record Snapshot(
    State state,
    Optional<BufferedImage> picture,
    Optional<Image> linear,
    double done,
    double left,
    long rays,
    double seconds,
    double error,
    Optional<Findings> findings,
    List<Rectangle> inWork,
    String message) {

  /** Returns that nothing is known yet. */
  static Snapshot preparing() {
    return plain(State.PREPARING, Optional.empty(), 0);
  }

  /** Returns a picture on the way of the camera. */
  static Snapshot moving(Motion.Frame frame) {
    return plain(State.MOVING, Optional.of(frame.picture()), frame.seconds());
  }

  private static Snapshot plain(State state, Optional<BufferedImage> picture, double seconds) {
    double unknown = Double.POSITIVE_INFINITY;
    Optional<Image> linear = Optional.empty();
    Optional<Findings> findings = Optional.empty();
    return new Snapshot(
        state, picture, linear, 0, unknown, 0, seconds, unknown, findings, List.of(), "");
  }

  /** Where a render stands. */
  enum State {
    /** The camera moves: its pictures are of few pixels, and each is the last of its kind. */
    MOVING("moving"),
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
