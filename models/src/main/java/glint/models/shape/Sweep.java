package glint.models.shape;

import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/** Round tubes along curves. */
public final class Sweep {

  private Sweep() {}

  /**
   * Returns the body around a path.
   *
   * <p>The rings are carried along without twist, by turning each as little as the path turns.
   *
   * @param radius of the ring at a share of the path, 0 to 1
   */
  public static Shape tube(List<Vector3d> path, int segments, DoubleUnaryOperator radius) {
    int last = path.size() - 1;
    List<List<Vector3d>> rings = new ArrayList<>();
    Vector3d aside = across(path.get(1).minus(path.get(0)).normalized());
    for (int i = 0; i <= last; i++) {
      Vector3d along =
          path.get(Math.min(i + 1, last)).minus(path.get(Math.max(i - 1, 0))).normalized();
      aside = aside.minus(along.times(aside.dot(along))).normalized();
      Vector3d beside = along.cross(aside);
      List<Vector3d> ring = new ArrayList<>();
      for (int k = 0; k < segments; k++) {
        double angle = 2 * Math.PI * k / segments;
        Vector3d out = aside.times(StrictMath.cos(angle)).plus(beside.times(StrictMath.sin(angle)));
        ring.add(path.get(i).plus(out.times(radius.applyAsDouble((double) i / last))));
      }
      rings.add(ring);
    }
    return Loft.body(path.get(0), rings, path.get(last));
  }

  /** Returns some unit vector at right angles to a unit vector. */
  private static Vector3d across(Vector3d along) {
    Vector3d other = Math.abs(along.x()) < 0.6 ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0);
    return along.cross(other).normalized();
  }
}
