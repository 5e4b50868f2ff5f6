package glint.scene;

import glint.math.BadValueException;
import glint.math.Check;

/**
 * Rays spread from the eye within an angle of view; immutable.
 *
 * @param degrees the full angle of view, more than 0 and less than 180
 * @param horizontal whether the angle runs across the picture rather than from bottom to top
 * @param aspect width over height of the picture plane, or 0 for that of the image, which makes
 *     pixels square
 */
public record Perspective(double degrees, boolean horizontal, double aspect) implements Projection {

  /** Checks the angle and the aspect. */
  public Perspective {
    if (!(degrees > 0 && degrees < 180)) {
      throw new BadValueException(
          "fov", "must be more than 0 and less than 180 degrees, but is " + degrees);
    }
    if (aspect != 0) {
      Check.positive("aspect", aspect);
    }
  }

  /** Returns half the height of the picture plane at distance 1. */
  @Override
  public double halfHeight(int width, int height) {
    double half = tanOfHalf(degrees);
    return horizontal ? half / shape(width, height) : half;
  }

  /** Returns half the width of the picture plane at distance 1. */
  @Override
  public double halfWidth(int width, int height) {
    double half = tanOfHalf(degrees);
    return horizontal ? half : half * shape(width, height);
  }

  private double shape(int width, int height) {
    return aspect == 0 ? (double) width / height : aspect;
  }

  /**
   * sin x / (1 + cos x) is exactly 1 for a right angle, where tan(x/2) is not; (1 - cos x) / sin x
   * is the same, and has a value up to 180 degrees.
   */
  private static double tanOfHalf(double degrees) {
    double x = StrictMath.toRadians(degrees);
    double sin = StrictMath.sin(x);
    double cos = StrictMath.cos(x);
    return cos < 0 ? (1 - cos) / sin : sin / (1 + cos);
  }
}
