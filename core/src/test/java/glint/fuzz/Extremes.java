package glint.fuzz;

import glint.color.Rgb;
import glint.math.Check;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/**
 * The numbers of one scene: of one size or of all sizes, and often again what came before, exactly
 * or one ulp beside it.
 */
final class Extremes {

  /** The exponents of 1e-100 and 1e100. */
  private static final int REACH = 332;

  private static final int LEAST_EXPONENT = -1074;

  private final Chance chance;

  /** Numbers are about as large as two to the power of this, */
  private final int centre;

  /** give or take this. */
  private final int spread;

  private final List<Vector3d> points = new ArrayList<>();
  private final List<Double> numbers = new ArrayList<>();

  Extremes(Chance chance) {
    this.chance = chance;
    centre =
        switch (chance.below(8)) {
          case 0, 1, 2 -> 0;
          case 3 -> REACH;
          case 4 -> -REACH;
          case 5 -> chance.between(LEAST_EXPONENT, REACH);
          default -> chance.between(-REACH, REACH);
        };
    spread = (int) chance.of(0, 1, 4, 30, 120, REACH, 2 * REACH);
    numbers.add(magnitude());
    points.add(new Vector3d(coordinate(), coordinate(), coordinate()));
  }

  List<Vector3d> points() {
    return points;
  }

  /** Returns a positive number of this scene's size, up to the largest permitted. */
  private double magnitude() {
    int exponent = centre + chance.between(-spread, spread);
    double v = Math.scalb(1 + chance.unit(), Math.max(exponent, LEAST_EXPONENT));
    return Math.min(v, Check.LARGEST);
  }

  /** Returns a positive length. */
  double size() {
    double v =
        switch (chance.below(8)) {
          case 0 -> Math.abs(chance.of(numbers));
          case 1 -> Math.abs(beside(chance.of(numbers)));
          case 2 -> Math.scalb(1.0, Math.max(centre, LEAST_EXPONENT));
          default -> magnitude();
        };
    return v > 0 ? Math.min(v, Check.LARGEST) : magnitude();
  }

  /** Returns a coordinate. */
  double coordinate() {
    double v =
        switch (chance.below(24)) {
          case 0, 1 -> chance.sign() * 0.0;
          case 2 -> chance.sign() * chance.between(1, 9) * Double.MIN_VALUE;
          case 3, 4, 5 -> chance.of(numbers);
          case 6, 7 -> beside(chance.of(numbers));
          case 8 -> Math.scalb(chance.of(numbers), chance.between(-60, 60));
          case 9 -> -chance.of(numbers);
          case 10 -> chance.sign() * chance.of(Check.LARGEST, 1 / Check.LARGEST, 1, 0x1p-1022);
          case 11, 12, 13, 14 -> Math.scalb((double) chance.between(-4, 4), centre);
          default -> chance.sign() * magnitude();
        };
    double clamped = Math.min(Math.max(v, -Check.LARGEST), Check.LARGEST);
    if (clamped != 0 && chance.oneIn(2)) {
      numbers.add(clamped);
    }
    return clamped;
  }

  /** Returns a point, and remembers it. */
  Vector3d point() {
    Vector3d p =
        switch (chance.below(8)) {
          case 0, 1 -> chance.of(points);
          case 2 -> {
            Vector3d q = chance.of(points);
            yield switch (chance.below(3)) {
              case 0 -> new Vector3d(beside(q.x()), q.y(), q.z());
              case 1 -> new Vector3d(q.x(), beside(q.y()), q.z());
              default -> new Vector3d(q.x(), q.y(), coordinate());
            };
          }
          case 3 -> {
            double s = chance.of(0.5, chance.unit(), 0x1p-30);
            yield chance.of(points).times(1 - s).plus(chance.of(points).times(s));
          }
          case 4 -> offset(chance.of(points), size());
          default -> new Vector3d(coordinate(), coordinate(), coordinate());
        };
    p = new Vector3d(clamp(p.x()), clamp(p.y()), clamp(p.z()));
    points.add(p);
    return p;
  }

  /** Returns a point at about a distance of another. */
  Vector3d offset(Vector3d from, double distance) {
    Vector3d to = from.plus(direction().normalized().times(distance));
    return new Vector3d(clamp(to.x()), clamp(to.y()), clamp(to.z()));
  }

  /** Returns a vector that is not zero. */
  Vector3d direction() {
    double zero = chance.sign() * 0.0;
    Vector3d d =
        switch (chance.below(8)) {
          case 0 -> new Vector3d(chance.sign(), zero, -zero);
          case 1 -> new Vector3d(zero, chance.sign() * size(), zero);
          case 2 -> new Vector3d(-zero, zero, coordinate());
          case 3 -> new Vector3d(chance.between(-1, 1), chance.between(-1, 1), zero);
          case 4 -> new Vector3d(coordinate(), coordinate(), coordinate());
          case 5 -> chance.of(points).minus(chance.of(points)).times(0.5);
          default -> new Vector3d(signed(), signed(), signed());
        };
    return d.maxAbs() > 0 ? d : new Vector3d(0.6, zero, -0.8);
  }

  /** Returns a chain of up to three steps, as scene files allow them. */
  Transform transform() {
    Transform product = Transform.IDENTITY;
    for (int steps = chance.below(4); steps > 0; steps--) {
      product = product.then(step());
    }
    return product;
  }

  private Transform step() {
    double even = factor();
    return switch (chance.below(7)) {
      case 0 -> Transform.scale(new Vector3d(even, chance.sign() * even, even));
      case 1, 2 -> Transform.scale(new Vector3d(factor(), factor(), factor()));
      case 3 -> Transform.rotate(Quaternion.aboutAxis(direction(), chance.of(90, 180, 45, 1e-9)));
      case 4 -> Transform.rotate(Quaternion.aboutAxis(direction(), 360 * chance.unit()));
      case 5 -> Transform.translate(point());
      default -> matrix();
    };
  }

  /** Returns a map that shears, often one that nearly or exactly flattens space. */
  private Transform matrix() {
    double[] rows = new double[12];
    for (int i = 0; i < 12; i++) {
      rows[i] = chance.of(0, 1, signed(), i < 4 ? signed() : rows[i - 4], i % 4 == 3 ? size() : 1);
    }
    return Transform.matrix(rows);
  }

  private double factor() {
    int exponent =
        switch (chance.below(6)) {
          case 0 -> 0;
          case 1 -> chance.between(-REACH, REACH);
          case 2 -> chance.between(-40, 40);
          default -> chance.between(-3, 3);
        };
    double mantissa = chance.oneIn(3) ? 1 : 1 + chance.unit();
    return chance.sign() * Math.min(Math.scalb(mantissa, exponent), Check.LARGEST);
  }

  /** Returns a colour: no component above 1e6, so that every sum of products is finite. */
  Rgb color(double greatest) {
    return switch (chance.below(5)) {
      case 0 -> Rgb.WHITE.times(Math.min(greatest, 1));
      case 1 -> Rgb.BLACK;
      case 2 -> new Rgb(0, greatest, Double.MIN_VALUE);
      case 3 -> Rgb.grey(greatest * chance.unit());
      default -> new Rgb(greatest * chance.unit(), chance.unit() * Math.min(greatest, 1), 0);
    };
  }

  private double signed() {
    return 2 * chance.unit() - 1;
  }

  /** Returns a neighbour among the doubles. */
  private double beside(double v) {
    return chance.oneIn(2) ? Math.nextUp(v) : Math.nextDown(v);
  }

  private static double clamp(double v) {
    return Math.min(Math.max(v, -Check.LARGEST), Check.LARGEST);
  }
}
