package glint.accel;

import glint.geometry.Ray;

/** A ray as the slabs of boxes see it; scratch. */
final class Slabs {

  /**
   * The least magnitude of a direction component, so that no slab computes 0·∞. A ray that runs so
   * straight leaves a slab by far less than a box's margin.
   */
  private static final double LEAST_COMPONENT = 1e-150;

  /**
   * How far, in units of u times the largest coordinate at hand, a kernel's hit may lie off its
   * primitive, with room for the slab's own rounding.
   *
   * <p>The widest band of any kernel is the cylinder's, 36u(|o - c| + size), and that sum is at
   * most 2√3 + 1 times the largest coordinate: 161u. See docs/numerics.md.
   */
  static final double SLACK = 256 * 0x1p-53;

  // The reciprocal direction, and origins moved apart for near and far planes.
  private double inverseX;
  private double inverseY;
  private double inverseZ;
  private double nearX;
  private double nearY;
  private double nearZ;
  private double farX;
  private double farY;
  private double farZ;

  // Where in a box the near plane of each axis stands; the far one is at the other of two places.
  private int lowX;
  private int lowY;
  private int lowZ;

  /**
   * Moves the origin back for near planes and forward for far ones, axis by axis.
   *
   * <p>A slab's t, (plane - o)·(1/d), is off by at most 3 roundings: as if the plane were moved by
   * 3u|plane - o|. A kernel's hit lies off its primitive by a few u(|o| + |primitive|), times the
   * conditioning of a transform. Moving the planes apart by more than both misses no hit.
   *
   * @param size the largest coordinate of the boxes
   */
  void set(Ray ray, double size, double conditioning) {
    double slack = SLACK * conditioning * reach(ray, size);
    double dx = steep(ray.dx);
    double dy = steep(ray.dy);
    double dz = steep(ray.dz);
    inverseX = 1 / dx;
    inverseY = 1 / dy;
    inverseZ = 1 / dz;
    nearX = dx > 0 ? ray.ox + slack : ray.ox - slack;
    nearY = dy > 0 ? ray.oy + slack : ray.oy - slack;
    nearZ = dz > 0 ? ray.oz + slack : ray.oz - slack;
    farX = dx > 0 ? ray.ox - slack : ray.ox + slack;
    farY = dy > 0 ? ray.oy - slack : ray.oy + slack;
    farZ = dz > 0 ? ray.oz - slack : ray.oz + slack;
    lowX = dx > 0 ? 0 : 3;
    lowY = dy > 0 ? 1 : 4;
    lowZ = dz > 0 ? 2 : 5;
  }

  /** Returns the largest coordinate at hand, or NaN, which no box is near, if not all is finite. */
  private static double reach(Ray ray, double size) {
    double reach = size + Math.max(Math.abs(ray.ox), Math.max(Math.abs(ray.oy), Math.abs(ray.oz)));
    return reach + 0 * (ray.dx + ray.dy + ray.dz + reach);
  }

  private static double steep(double d) {
    return Math.abs(d) < LEAST_COMPONENT ? Math.copySign(LEAST_COMPONENT, d) : d;
  }

  /**
   * The t at which the ray has entered a box, not before {@code start}.
   *
   * <p>Numbers are compared by the upper halves of their bits. For those of zero and above, which a
   * maximum with {@code start} is, that never turns an order round, so no box is missed; and the
   * maxima and minima of ints need no branch, which incoherent rays would often mispredict.
   *
   * @param boxes the bits of floats, six a box: the least corner, then the greatest
   * @param at where the box begins
   */
  int enter(int[] boxes, int at, int start) {
    int tx = bits((Float.intBitsToFloat(boxes[at + lowX]) - nearX) * inverseX);
    int ty = bits((Float.intBitsToFloat(boxes[at + lowY]) - nearY) * inverseY);
    int tz = bits((Float.intBitsToFloat(boxes[at + lowZ]) - nearZ) * inverseZ);
    return Math.max(Math.max(tx, ty), Math.max(tz, start));
  }

  /** The t at which the ray leaves a box, at most {@code end}; or below zero. */
  int leave(int[] boxes, int at, int end) {
    int tx = bits((Float.intBitsToFloat(boxes[at + 3 - lowX]) - farX) * inverseX);
    int ty = bits((Float.intBitsToFloat(boxes[at + 5 - lowY]) - farY) * inverseY);
    int tz = bits((Float.intBitsToFloat(boxes[at + 7 - lowZ]) - farZ) * inverseZ);
    return Math.min(Math.min(tx, ty), Math.min(tz, end));
  }

  /** The upper half of the bits of a t. */
  static int bits(double t) {
    return (int) (Double.doubleToRawLongBits(t) >> 32);
  }
}
