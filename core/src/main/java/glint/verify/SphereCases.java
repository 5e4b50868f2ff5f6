package glint.verify;

import glint.geometry.Sphere;
import glint.math.BadValueException;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.math.BigDecimal;
import java.util.List;

/** Spheres: tangents, far and huge ones, inside and behind, and powers of two. */
final class SphereCases {

  private static final Vector3d X = new Vector3d(1, 0, 0);
  private static final Sphere UNIT = new Sphere(Vector3d.ZERO, 1);

  private SphereCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact("S01", "a tangent ray hits, at t = 10 exactly", SphereCases::tangent),
        HardCase.exact("S02", "a ray one ulp outside the tangent misses", SphereCases::outside),
        HardCase.within("S03", "one ulp inside it hits", 1e-8, "r", SphereCases::inside),
        HardCase.within("S04", "unit sphere at distance 2^30", 2, "ulp", SphereCases::farDyadic),
        HardCase.exact("S05", "r = 1e-3 at distance 1e6, D sign per ray", SphereCases::tinyFar),
        HardCase.within("S06", "r = 1 at distance 1e8", 8, "u·S", SphereCases::far),
        HardCase.within("S07", "r = 1e6 and 1e9 below the eye", 4, "ulp(r)", SphereCases::below),
        HardCase.within("S08", "r = 1e6, slope 4e-3", 8, "u·S·r/√D", SphereCases::huge),
        HardCase.exact("S09", "3-4-5: t = 6 and 14 bit-exact", SphereCases::pythagoras),
        HardCase.within("S10", "from the centre", 2, "ulp(r)", SphereCases::center),
        HardCase.within("S11", "from inside: the far root", 8, "u·S·r/√D", SphereCases::within),
        HardCase.exact("S12", "a sphere behind the eye is missed", SphereCases::behind),
        HardCase.exact("S15", "d·2^k gives t·2^-k, bit for bit", SphereCases::longDirections),
        HardCase.exact("S16", "world·2^k gives t·2^k, bit for bit", SphereCases::scaledWorld),
        HardCase.exact("S18", "r = 0, -1, NaN, ∞ are refused by name", SphereCases::badRadius));
  }

  private static void tangent(Tally tally) {
    Shoot shoot = Shoot.at(UNIT);
    tally.check(shoot.from(new Vector3d(-10, 1, 0), X) && shoot.hit.t == 10);
  }

  private static void outside(Tally tally) {
    tally.check(!Shoot.at(UNIT).from(new Vector3d(-10, Math.nextUp(1.0), 0), X));
  }

  private static void inside(Tally tally) {
    Vector3d o = new Vector3d(-10, Math.nextDown(1.0), 0);
    Shoot shoot = Shoot.at(UNIT);
    tally.check(shoot.from(o, X));
    tally.error(Math.abs(shoot.hit.t - Exact.toDouble(nearest(UNIT, o, X).t())));
  }

  private static void farDyadic(Tally tally) {
    Vector3d o = new Vector3d(-0x1p30, 0.5, 0);
    Shoot shoot = Shoot.at(UNIT);
    tally.check(shoot.from(o, X));
    BigDecimal t = nearest(UNIT, o, X).t();
    double error = Exact.toDouble(Exact.of(shoot.hit.t).subtract(t).abs());
    tally.error(error / Math.ulp(shoot.hit.t));
  }

  private static void tinyFar(Tally tally) {
    Dice dice = new Dice(5);
    Sphere tiny = new Sphere(Vector3d.ZERO, 1e-3);
    Shoot shoot = Shoot.at(tiny);
    SphereOracle oracle = new SphereOracle(tiny);
    for (int i = 0; i < 4000; i++) {
      Vector3d o = dice.unit().times(1e6);
      // Three of four at points within the sphere, the others past it.
      double aside = i % 4 == 0 ? dice.in(1.1, 2) : 0.9 * dice.in(0, 1);
      Vector3d d = dice.across(o).times(aside * 1e-3).minus(o);
      List<Crossing> truth = oracle.crossings(o, d);
      tally.check(shoot.from(o, d) == (truth.get(0).inside() >= 0));
    }
  }

  private static void far(Tally tally) {
    Dice dice = new Dice(6);
    Shoot shoot = Shoot.at(UNIT);
    for (int i = 0; i < 4000; i++) {
      Vector3d o = dice.unit().times(1e8);
      Vector3d d = dice.ball(0.9).minus(o);
      tally.check(shoot.from(o, d));
      double error = Exact.toDouble(Exact.of(shoot.hit.t).subtract(nearest(UNIT, o, d).t()).abs());
      tally.error(error * d.length() / (Rounding.U * (o.length() + 1)));
    }
  }

  private static void below(Tally tally) {
    Dice dice = new Dice(7);
    for (double r : new double[] {1e6, 1e9}) {
      Sphere ground = new Sphere(new Vector3d(0, -r, 0), r);
      Shoot shoot = Shoot.at(ground);
      for (int i = 0; i < 2000; i++) {
        Vector3d o = new Vector3d(0, dice.in(0.9, 1.1), 0);
        Vector3d d = new Vector3d(dice.in(-1, 1), -dice.log(0.02, 1), dice.in(-1, 1));
        tally.check(shoot.from(o, d));
        tally.error(residual(ground, shoot) / Math.ulp(r));
      }
    }
  }

  private static void huge(Tally tally) {
    Dice dice = new Dice(8);
    Sphere ground = new Sphere(new Vector3d(0, -1e6, 0), 1e6);
    Shoot shoot = Shoot.at(ground);
    for (int i = 0; i < 2000; i++) {
      Vector3d o = new Vector3d(0, dice.in(0.9, 1.1), 0);
      Vector3d d = dice.across(new Vector3d(0, 1, 0)).plus(new Vector3d(0, -4e-3, 0));
      tally.check(shoot.from(o, d) && residual(ground, shoot) <= 4 * Math.ulp(1e6));
      tally.error(nearest(ground, o, d).errorOf(shoot.hit.t));
    }
  }

  /** How far the resolved point lies off the sphere. */
  private static double residual(Sphere s, Shoot shoot) {
    shoot.resolve();
    Exact3 p = Exact3.of(shoot.point()).minus(Exact3.of(s.center()));
    return Math.abs(Exact.toDouble(Exact.sqrt(p.squared()).subtract(Exact.of(s.radius()))));
  }

  private static void pythagoras(Tally tally) {
    Shoot shoot = Shoot.at(new Sphere(Vector3d.ZERO, 5));
    tally.check(shoot.from(new Vector3d(-10, 3, 0), X) && shoot.hit.t == 6);
    shoot.ray.tMin = 6;
    tally.check(shoot.closest() && shoot.hit.t == 14);
  }

  private static void center(Tally tally) {
    Dice dice = new Dice(10);
    for (int i = 0; i < 1000; i++) {
      Sphere s = new Sphere(dice.cube(10), dice.log(1e-3, 1e3));
      Vector3d d = dice.unit();
      Shoot shoot = Shoot.at(s);
      boolean hit = shoot.from(s.center(), d);
      shoot.resolve();
      tally.check(hit && shoot.normal().minus(d).maxAbs() <= 2 * Rounding.U);
      tally.error(Math.abs(shoot.hit.t - s.radius()) / Math.ulp(s.radius()));
      shoot.ray.tMin = shoot.hit.t;
      tally.check(!shoot.closest());
    }
  }

  private static void within(Tally tally) {
    Dice dice = new Dice(11);
    for (int i = 0; i < 2000; i++) {
      Sphere s = new Sphere(dice.cube(10), dice.log(1e-3, 1e3));
      Vector3d o = s.center().plus(dice.ball(0.99 * s.radius()));
      Vector3d d = dice.unit();
      Shoot shoot = Shoot.at(s);
      boolean hit = shoot.from(o, d);
      shoot.resolve();
      tally.check(hit && shoot.normal().dot(d) > 0);
      Crossing far = new SphereOracle(s).crossings(o, d).get(1);
      tally.error(far.errorOf(shoot.hit.t));
    }
  }

  private static void behind(Tally tally) {
    Dice dice = new Dice(12);
    Shoot shoot = Shoot.at(UNIT);
    for (int i = 0; i < 1000; i++) {
      Vector3d o = dice.unit().times(dice.log(1.001, 1e9));
      tally.check(!shoot.from(o, o.plus(dice.ball(0.5))));
    }
  }

  private static void longDirections(Tally tally) {
    Dice dice = new Dice(15);
    Shoot shoot = Shoot.at(new Sphere(new Vector3d(0.1, 0.2, 0.3), 0.7));
    for (int i = 0; i < 20; i++) {
      Vector3d o = dice.cube(5);
      Vector3d d = dice.ball(0.6).minus(o);
      double t = shoot.from(o, d) ? shoot.hit.t : 0;
      for (int k = -60; k <= 60; k++) {
        double again = shoot.from(o, d.times(Math.scalb(1.0, k))) ? shoot.hit.t : 0;
        tally.check(again == Math.scalb(t, -k));
      }
    }
  }

  private static void scaledWorld(Tally tally) {
    Dice dice = new Dice(16);
    for (int i = 0; i < 20; i++) {
      Vector3d c = dice.cube(3);
      double r = dice.log(0.1, 3);
      Vector3d o = dice.cube(5);
      Vector3d d = c.plus(dice.ball(1.2 * r)).minus(o);
      Shoot shoot = Shoot.at(new Sphere(c, r));
      double t = shoot.from(o, d) ? shoot.hit.t : 0;
      for (int k = -60; k <= 60; k++) {
        double s = Math.scalb(1.0, k);
        Shoot scaled = Shoot.at(new Sphere(c.times(s), r * s));
        double again = scaled.from(o.times(s), d) ? scaled.hit.t : 0;
        tally.check(again == Math.scalb(t, k));
      }
    }
  }

  private static void badRadius(Tally tally) {
    for (double r : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      tally.check(refusesRadius(r));
    }
  }

  private static boolean refusesRadius(double r) {
    try {
      new Sphere(Vector3d.ZERO, r);
      return false;
    } catch (BadValueException e) {
      return e.getMessage().contains("radius");
    }
  }

  private static Crossing nearest(Sphere s, Vector3d o, Vector3d d) {
    return new SphereOracle(s).crossings(o, d).get(0);
  }
}
