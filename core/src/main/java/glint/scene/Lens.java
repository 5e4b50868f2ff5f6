package glint.scene;

import glint.math.Check;

/**
 * A thin lens: what lies on the plane at the distance of focus is sharp, everything else a disc;
 * immutable.
 *
 * @param radius of the lens, in scene units; 0 for a pinhole
 * @param focus the distance, along the view, of what is sharp
 */
public record Lens(double radius, double focus) {

  /** Checks both. */
  public Lens {
    Check.range("radius", radius, 0, Check.LARGEST);
    Check.positive("focus", focus);
  }
}
