package glint.models.shape;

import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/** Surfaces of revolution around the y axis. */
public final class Lathe {

  private Lathe() {}

  /**
   * Returns the closed body of a profile.
   *
   * @param profile radii and heights in turn, from the bottom up; the first and last radius are 0
   */
  public static Shape body(int segments, double... profile) {
    int last = profile.length - 2;
    if (profile[0] != 0 || profile[last] != 0) {
      throw new IllegalArgumentException("a body begins and ends on the axis");
    }
    List<List<Vector3d>> rings = new ArrayList<>();
    for (int i = 2; i < last; i += 2) {
      rings.add(ring(segments, profile[i], profile[i + 1]));
    }
    return Loft.body(new Vector3d(0, profile[1], 0), rings, new Vector3d(0, profile[last + 1], 0));
  }

  /** Returns the open surface of a profile; no radius is 0. */
  public static Shape tube(int segments, double... profile) {
    List<List<Vector3d>> rings = new ArrayList<>();
    for (int i = 0; i < profile.length; i += 2) {
      rings.add(ring(segments, profile[i], profile[i + 1]));
    }
    return Loft.tube(rings);
  }

  /** Returns points around the y axis, counter-clockwise as seen from below: outside is out. */
  public static List<Vector3d> ring(int segments, double radius, double y) {
    List<Vector3d> ring = new ArrayList<>();
    for (int i = 0; i < segments; i++) {
      double angle = 2 * Math.PI * i / segments;
      double x = radius * StrictMath.sin(angle);
      ring.add(new Vector3d(x, y, radius * StrictMath.cos(angle)));
    }
    return ring;
  }
}
