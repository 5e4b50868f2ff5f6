package glint.scene;

import glint.math.Check;

/**
 * All rays are parallel to the view and begin on the plane through the eye, square to it;
 * immutable.
 *
 * @param planeHeight the full height of the picture in scene units; pixels are square
 */
public record Orthographic(double planeHeight) implements Projection {

  /** Checks the height. */
  public Orthographic {
    Check.positive("orthographic", planeHeight);
  }

  /** Returns half the height of the picture plane in scene units. */
  @Override
  public double halfHeight(int width, int height) {
    return planeHeight / 2;
  }

  /** Returns half the width of the picture plane in scene units. */
  @Override
  public double halfWidth(int width, int height) {
    return planeHeight / 2 * ((double) width / height);
  }
}
