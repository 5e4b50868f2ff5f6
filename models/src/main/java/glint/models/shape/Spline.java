package glint.models.shape;

import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/** Smooth curves through points: the uniform spline of Catmull and Rom (1974). */
public final class Spline {

  private Spline() {}

  /** Returns the points and, between two of them, so many steps. */
  public static List<Vector3d> through(int steps, Vector3d... knots) {
    int last = knots.length - 1;
    List<Vector3d> curve = new ArrayList<>();
    for (int i = 0; i < last; i++) {
      Vector3d before = knots[Math.max(i - 1, 0)];
      Vector3d after = knots[Math.min(i + 2, last)];
      for (int k = 0; k < steps; k++) {
        curve.add(at(before, knots[i], knots[i + 1], after, (double) k / steps));
      }
    }
    curve.add(knots[last]);
    return curve;
  }

  private static Vector3d at(Vector3d a, Vector3d b, Vector3d c, Vector3d d, double t) {
    Vector3d linear = c.minus(a).times(t / 2);
    Vector3d square = a.times(2).minus(b.times(5)).plus(c.times(4)).minus(d).times(t * t / 2);
    Vector3d cube = b.minus(c).times(3).plus(d).minus(a).times(t * t * t / 2);
    return b.plus(linear).plus(square).plus(cube);
  }
}
