package glint.scene;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Quaternion;
import glint.math.Vector3d;
import java.util.Locale;
import java.util.Optional;

/**
 * A camera's way around what it looks at, in even steps; immutable.
 *
 * <p>The camera goes round, and lights and surfaces stay. The first frame is the camera's own
 * picture; one more step after the last ends the turn, so that a full turn repeats no picture.
 *
 * @param frames how many pictures there are, up to {@link #MOST_FRAMES}
 * @param axis the direction that the camera goes about, counter-clockwise when it points at the
 *     viewer
 * @param degrees the whole turn; negative for clockwise
 * @param about a point on the axis; if absent, where the camera looks
 */
public record Turntable(int frames, Vector3d axis, double degrees, Optional<Vector3d> about) {

  /** As many as four digits count. */
  public static final int MOST_FRAMES = 9999;

  /** The most degrees of a turn: more would only lose precision. */
  public static final double MOST_DEGREES = 36_000;

  /** The turn between two keys, less than half of which is the shorter way. */
  private static final double KEY = 90;

  /** Checks all values. */
  public Turntable {
    if (frames < 1 || frames > MOST_FRAMES) {
      throw new BadValueException("frames", "must be 1 to " + MOST_FRAMES + ", but is " + frames);
    }
    Check.direction("axis", axis);
    Check.range("degrees", degrees, -MOST_DEGREES, MOST_DEGREES);
    about.ifPresent(point -> Check.finite("about", point));
  }

  /** Returns what the name of a frame adds to the scene's: ".0001" for the first. */
  static String suffix(int frame) {
    return String.format(Locale.ROOT, ".%04d", frame);
  }

  /** Returns the rotation that leads from the first frame to another; frames count from 1. */
  Quaternion turn(int frame) {
    int keys = (int) Math.ceil(Math.abs(degrees) / KEY);
    double way = (double) keys * (frame - 1) / frames;
    int before = (int) way;
    return key(before, keys).slerp(key(before + 1, keys), way - before);
  }

  private Quaternion key(int number, int keys) {
    return Quaternion.aboutAxis(axis, keys == 0 ? 0 : degrees * number / keys);
  }

  /**
   * Returns a frame's camera.
   *
   * @throws BadValueException if it leaves the range of coordinates
   */
  Camera camera(Camera first, int frame) {
    return frame == 1 ? first : first.turned(about.orElse(first.lookAt()), turn(frame));
  }
}
