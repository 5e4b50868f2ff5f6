package glint.verify;

import glint.geometry.Cylinder;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Where a line meets a cylinder, cone or frustum.
 *
 * <p>The truth is the surface |w| = r + m·s with s = (p - base)·a and w = p - base - s·a for the
 * axis a, height and slope m as they are stored, rounded: only an axis along x, y or z is a unit
 * vector exactly. With e the direction across the axis, D = (w·e - m dₛ ρ)² - (e² - m²dₛ²)(w² - ρ²)
 * decides by its sign.
 */
final class CylinderOracle implements Oracle {

  /**
   * How far from silhouette, rim or tip, in u·S with S = |f| + height + radii, the kernel may
   * decide either way.
   *
   * <p>Moving the origin next to the solid errs by 3uS. From there on all numbers are at most its
   * size: splitting along and across the axis and going on to the nearest point adds 12u to l, 8u
   * to s and with that 10u to ρ, seen across the side; the vectors in D = |ρe - m dₛ w|² - |w × e|²
   * err by 2u a product and their squares by 3/2, which makes 9u.
   */
  static final Bound DECISION = new Bound(36, "u·S");

  /**
   * The largest error of t|d|, in u·S/cos with cos that of ray and normal.
   *
   * <p>The same errors, divided by the cosine, and 8u for the root and 2u for adding it to where it
   * was looked for.
   */
  static final Bound PARAMETER = new Bound(48, "u·S/cos");

  private final Exact3 base;
  private final Exact3 axis;
  private final BigDecimal height;
  private final BigDecimal radius;
  private final BigDecimal slope;
  private final double tilt;
  private final double extent;
  private final boolean capped;

  CylinderOracle(Cylinder cylinder) {
    Vector3d along = cylinder.top().minus(cylinder.base());
    double length = along.dot(along.normalized());
    double m = (cylinder.topRadius() - cylinder.radius()) / length;
    base = Exact3.of(cylinder.base());
    axis = Exact3.of(along.normalized());
    height = Exact.of(length);
    radius = Exact.of(cylinder.radius());
    slope = Exact.of(m);
    tilt = Math.sqrt(1 + m * m);
    extent = length + cylinder.radius() + cylinder.topRadius();
    capped = cylinder.capped();
  }

  @Override
  public List<Crossing> crossings(Vector3d origin, Vector3d direction) {
    Line line = new Line(Exact3.of(origin).minus(base), Exact3.of(direction));
    List<Crossing> all = new ArrayList<>();
    line.addSide(all);
    if (capped && line.ds.signum() != 0) {
      all.add(line.atBase.cap);
      all.add(line.atTop.cap);
    }
    return capped ? notThinner(all) : all;
  }

  @Override
  public double off(Vector3d origin, Vector3d direction, double t) {
    Line line = new Line(Exact3.of(origin).minus(base), Exact3.of(direction));
    BigDecimal s = line.fs.add(line.ds.multiply(Exact.of(t)));
    double far = line.w.plus(line.e.times(Exact.of(t))).length();
    double high = Exact.toDouble(s);
    double top = Exact.toDouble(height);
    double rho = Exact.toDouble(radius.add(slope.multiply(s)));
    double beyond = Math.max(0, Math.max(-high, high - top));
    double least = Math.max(Math.abs(far - rho) / tilt, beyond);
    return least / line.scale;
  }

  /** A solid where the line leaves it as soon as it has entered is no surer than that is. */
  private static List<Crossing> notThinner(List<Crossing> all) {
    List<Crossing> hits = all.stream().filter(c -> c.inside() >= 0).collect(Collectors.toList());
    if (hits.size() != 2) {
      return all;
    }
    double way = Math.abs(Exact.toDouble(hits.get(0).t().subtract(hits.get(1).t())));
    double chord = way / Math.max(hits.get(0).unit(), hits.get(1).unit());
    return all.stream()
        .map(c -> new Crossing(c.t(), c.unit(), Math.min(c.inside(), chord)))
        .collect(Collectors.toList());
  }

  /** A line, split into parts along and across the axis. */
  private final class Line {

    final BigDecimal fs;
    final BigDecimal ds;
    final Exact3 w;
    final Exact3 e;
    final double length;

    /** u·S, the unit of every distance. */
    final double scale;

    final Rim atBase;
    final Rim atTop;

    Line(Exact3 f, Exact3 d) {
      fs = f.dot(axis);
      ds = d.dot(axis);
      w = f.minus(axis.times(fs));
      e = d.minus(axis.times(ds));
      length = d.length();
      scale = Rounding.U * (f.length() + extent);
      atBase = rim(BigDecimal.ZERO);
      atTop = rim(height);
    }

    void addSide(List<Crossing> all) {
      BigDecimal across = e.squared();
      BigDecimal widening = slope.multiply(ds);
      BigDecimal rho = radius.add(slope.multiply(fs));
      BigDecimal qa = across.subtract(Exact.square(widening));
      BigDecimal qb = w.dot(e).subtract(widening.multiply(rho));
      BigDecimal qc = w.squared().subtract(Exact.square(rho));
      BigDecimal discriminant = Exact.square(qb).subtract(qa.multiply(qc));
      if (qa.signum() == 0) {
        if (qb.signum() != 0) {
          BigDecimal t = Exact.ratio(qc, qb.add(qb).negate());
          all.add(side(t, Exact.toDouble(qb), Double.POSITIVE_INFINITY));
        }
        return;
      }
      double margin = margin(discriminant, across, qa);
      if (discriminant.signum() < 0) {
        all.add(side(Exact.ratio(qb.negate(), qa), 0, margin));
        return;
      }
      BigDecimal root = Exact.sqrt(discriminant);
      double half = Exact.toDouble(root);
      all.add(side(Exact.ratio(qb.negate().subtract(root), qa), -half, margin));
      all.add(side(Exact.ratio(qb.negate().add(root), qa), half, margin));
    }

    /**
     * The largest of (ρ - |w|)/√(1 + m²) along the line: D over the sum of ρ and the distance to
     * the axis where they compare.
     */
    private double margin(BigDecimal discriminant, BigDecimal across, BigDecimal qa) {
      if (across.signum() == 0) {
        return Double.POSITIVE_INFINITY;
      }
      BigDecimal nearest = Exact.ratio(w.dot(e).negate(), across);
      double rho = Exact.toDouble(radius.add(slope.multiply(fs.add(nearest.multiply(ds)))));
      BigDecimal l2 = w.squared().add(nearest.multiply(w.dot(e)));
      double share = Exact.toDouble(Exact.ratio(qa.abs(), across));
      double sum = Math.abs(rho) + Math.sqrt(Math.abs(Exact.toDouble(l2)) * share);
      double d = Exact.toDouble(Exact.ratio(discriminant, across));
      return sum == 0 ? 0 : d / (sum * tilt * scale);
    }

    /**
     * A crossing of the side, cut off at both ends.
     *
     * @param half √D, the crossing's rate times |w|, below 0 at the first crossing
     */
    private Crossing side(BigDecimal t, double half, double margin) {
      BigDecimal s = fs.add(t.multiply(ds));
      double rho = Math.abs(Exact.toDouble(radius.add(slope.multiply(s))));
      boolean tip = rho <= DECISION.most() * scale;
      double cos = tip ? cosAtTip() : Math.min(1, Math.abs(half) / (rho * tilt * length));
      double inside = Math.min(rim(atBase, s, half), rim(atTop, height.subtract(s), half));
      return new Crossing(t, scale / (cos * length), Math.min(margin, inside / scale));
    }

    /** At a tip, the least cos of the line and any normal. */
    private double cosAtTip() {
      double widening = Math.abs(Exact.toDouble(slope) * Exact.toDouble(ds));
      return Math.abs(e.length() - widening) / (tilt * length);
    }

    /**
     * How far the line may move before a crossing of the side passes a rim: along the axis by its
     * height over the rim, or until the line meets the rim itself, where it is the same crossing if
     * the line enters or leaves there as it does here.
     */
    private double rim(Rim rim, BigDecimal over, double half) {
      double along = Exact.toDouble(over);
      boolean same = rim != null && half * rim.rate >= 0;
      return same ? Math.copySign(Math.min(Math.abs(along), rim.distance), along) : along;
    }

    /** Where the line crosses the plane of an end, or null if it never does. */
    private Rim rim(BigDecimal s) {
      if (ds.signum() == 0) {
        return null;
      }
      BigDecimal t = Exact.ratio(s.subtract(fs), ds);
      Exact3 there = w.plus(e.times(t));
      BigDecimal rho = radius.add(slope.multiply(s));
      double far = there.length();
      double sum = Math.abs(Exact.toDouble(rho)) + far;
      double within = Exact.toDouble(Exact.square(rho).subtract(there.squared()));
      BigDecimal along = there.dot(e);
      double outward = far > 0 ? Exact.toDouble(along) / (far * Exact.toDouble(ds)) : 0;
      double inside = sum > 0 ? within / (sum * Math.sqrt(1 + outward * outward)) : 0;
      double rate = Exact.toDouble(along.subtract(rho.multiply(slope).multiply(ds)));
      boolean tip = Math.abs(Exact.toDouble(rho)) <= DECISION.most() * scale;
      double cos = Math.abs(Exact.toDouble(ds)) / length;
      Crossing cap = new Crossing(t, scale / (cos * length), inside / scale);
      return new Rim(cap, Math.abs(inside), tip ? 0 : rate);
    }
  }

  /**
   * An end of the side as a line sees it.
   *
   * @param cap the crossing of its plane, inside where it is nearer to the axis than the rim
   * @param distance how far the line passes from the rim
   * @param rate below 0 where the line would enter at the rim, 0 where it may do both: at a tip
   */
  private record Rim(Crossing cap, double distance, double rate) {}
}
