package glint.verify;

import glint.geometry.Box;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;

/** Where a line meets a box: every face's plane by a rational parameter, no division by zero. */
final class BoxOracle implements Oracle {

  /**
   * How far from an edge, in u·S with S = t|d| + size, the kernel may decide either way: two
   * parameters of 2 roundings each part by 4ut, and the line leaves an edge no faster than by
   * |d|/√2 a unit of t.
   */
  static final Bound DECISION = new Bound(4, "u·S");

  /** The largest error of t, in u·t: a difference and a quotient (one more for u²). */
  static final Bound PARAMETER = new Bound(2.0000001, "u·t");

  private final double[][] corners;
  private final double size;

  BoxOracle(Box box) {
    corners = new double[][] {axes(box.min()), axes(box.max())};
    size = box.max().minus(box.min()).length();
  }

  private static double[] axes(Vector3d v) {
    return new double[] {v.x(), v.y(), v.z()};
  }

  @Override
  public List<Crossing> crossings(Vector3d origin, Vector3d direction) {
    double[] o = axes(origin);
    double[] d = axes(direction);
    double length = Exact3.of(direction).length();
    List<Crossing> all = new ArrayList<>();
    for (int face = 0; face < 6; face++) {
      int axis = face % 3;
      if (d[axis] != 0) {
        BigDecimal way = Exact.of(corners[face / 3][axis]).subtract(Exact.of(o[axis]));
        BigDecimal t = Exact.ratio(way, Exact.of(d[axis]));
        double scale = Rounding.U * (Math.abs(Exact.toDouble(t)) * length + size);
        double inside = Double.POSITIVE_INFINITY;
        for (int other = 0; other < 3; other++) {
          if (other != axis) {
            inside = Math.min(inside, inside(t, o, d, axis, other) / scale);
          }
        }
        all.add(new Crossing(t, Rounding.U * Math.abs(Exact.toDouble(t)), inside));
      }
    }
    return all;
  }

  /** How far the line may move before it leaves a face of one axis at an edge of another. */
  private double inside(BigDecimal t, double[] o, double[] d, int axis, int other) {
    BigDecimal p = Exact.of(o[other]).add(t.multiply(Exact.of(d[other])));
    BigDecimal above = p.subtract(Exact.of(corners[0][other]));
    BigDecimal below = Exact.of(corners[1][other]).subtract(p);
    double slope = d[other] / d[axis];
    return Exact.toDouble(above.min(below)) / Math.sqrt(1 + slope * slope);
  }
}
