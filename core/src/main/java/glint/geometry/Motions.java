package glint.geometry;

import glint.math.Rounding;
import glint.math.Vector3d;
import java.util.Arrays;

/**
 * How far surfaces move, evenly and without turning, while the shutter is open; each shows from
 * where it is at time 0 to that at time 1.
 *
 * <p>A ray at a time sees the surface as a ray that is moved back sees it at time 0.
 */
final class Motions {

  /** The way of each surface, by its number: three numbers each. */
  private final double[] ways;

  Motions(double[] ways) {
    this.ways = ways;
  }

  /** Returns the ways with that of one more surface. */
  static double[] with(double[] ways, int surface, Vector3d way) {
    double[] more = Arrays.copyOf(ways, Math.max(ways.length, 3 * surface + 3));
    more[3 * surface] = way.x();
    more[3 * surface + 1] = way.y();
    more[3 * surface + 2] = way.z();
    return more;
  }

  double[] ways() {
    return ways;
  }

  boolean moves(int surface) {
    int i = 3 * surface;
    return i < ways.length && (ways[i] != 0 || ways[i + 1] != 0 || ways[i + 2] != 0);
  }

  /** Returns a ray as a surface that moves would see it at time 0. */
  Ray still(int surface, Ray ray) {
    Ray moved = ray.companion();
    double x = ray.time * ways[3 * surface];
    double y = ray.time * ways[3 * surface + 1];
    double z = ray.time * ways[3 * surface + 2];
    moved.set(ray.ox - x, ray.oy - y, ray.oz - z, ray.dx, ray.dy, ray.dz);
    moved.tMin = ray.tMin;
    moved.after = ray.after;
    return moved;
  }

  /**
   * Carries a hit that was found at time 0 to the time of its ray.
   *
   * <p>A point less certain by the rounding of the product and the sum, here and on the way back.
   */
  void carry(int surface, Ray ray, Hit hit) {
    hit.movedX = ray.time * ways[3 * surface];
    hit.movedY = ray.time * ways[3 * surface + 1];
    hit.movedZ = ray.time * ways[3 * surface + 2];
    hit.offset +=
        Rounding.gamma(8)
            * (Math.abs(hit.nx) * (Math.abs(hit.px) + Math.abs(hit.movedX))
                + Math.abs(hit.ny) * (Math.abs(hit.py) + Math.abs(hit.movedY))
                + Math.abs(hit.nz) * (Math.abs(hit.pz) + Math.abs(hit.movedZ)));
    hit.px += hit.movedX;
    hit.py += hit.movedY;
    hit.pz += hit.movedZ;
  }

  /** Widens the box of a surface at time 0 by its way. */
  void widen(int surface, double[] box) {
    for (int axis = 0; axis < 3; axis++) {
      double way = ways[3 * surface + axis];
      box[axis] = Math.min(box[axis], box[axis] + way);
      box[3 + axis] = Math.max(box[3 + axis], box[3 + axis] + way);
    }
  }
}
