package glint.verify;

import glint.math.Vector3d;
import java.util.List;

/** What is true of a surface and a line, computed without rounding. */
interface Oracle {

  /** Returns where the line {@code o + t d} crosses the surface, or barely fails to. */
  List<Crossing> crossings(Vector3d o, Vector3d d);

  /**
   * Returns how far the point at a parameter lies from the surface, in u·S; needed only where the
   * surface has straight lines, along which a ray may come and go anywhere.
   */
  default double off(Vector3d o, Vector3d d, double t) {
    return Double.POSITIVE_INFINITY;
  }
}
