package glint.verify;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Plane;
import glint.math.Rounding;
import glint.math.Vector3d;
import glint.optics.Fresnel;
import glint.optics.Material;
import glint.scene.Placement;
import glint.trace.Tracer;
import java.math.BigDecimal;
import java.util.List;

/** What Fresnel's and Snell's laws say of one boundary, against exact arithmetic. */
final class FresnelCases {

  private static final double GLASS = 1.5;

  private FresnelCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact("R02", "total reflection begins where it should", FresnelCases::critical),
        HardCase.exact("R02-rays", "beyond it no ray goes through", FresnelCases::transmitted),
        HardCase.within("R02-ulp", "an angle on the edge of it", 5, "u", FresnelCases::edge),
        HardCase.within("R03", "R + T = 1, T from the amplitudes", 8, "u", FresnelCases::energy),
        HardCase.within("R04", "light takes the same way back", 1e-14, "R", FresnelCases::back),
        HardCase.within(
            "R04-critical", "the same near critical", 28, "u/cos", FresnelCases::backFromCritical),
        HardCase.within("R12-share", "R → 1 at 90° - 1e-9", 8, "u", FresnelCases::grazing),
        HardCase.within(
            "R13", "Schlick is off by .0357 and .73 as known", 5e-5, "R", FresnelCases::schlick),
        HardCase.within("R13-floor", "rays reflect by the exact law", 8, "u", FresnelCases::floor));
  }

  /** Returns the share that is reflected. */
  static double reflectance(double cosIn, double eta) {
    return Fresnel.reflectance(cosIn, Fresnel.cosOut(cosIn, eta), eta);
  }

  /** Returns 1 - η² sin² i without rounding: its sign says whether light goes through. */
  private static BigDecimal through(double cosIn, double eta) {
    BigDecimal sinIn2 = BigDecimal.ONE.subtract(Exact.square(Exact.of(cosIn)));
    return BigDecimal.ONE.subtract(Exact.square(Exact.of(eta)).multiply(sinIn2));
  }

  /** Returns the share that is reflected, to sixty digits. */
  static BigDecimal exactReflectance(double cosIn, double eta) {
    BigDecimal cosOut2 = through(cosIn, eta);
    if (cosOut2.signum() < 0) {
      return BigDecimal.ONE;
    }
    BigDecimal out = Exact.sqrt(cosOut2);
    BigDecimal in = Exact.of(cosIn);
    BigDecimal n = Exact.of(eta);
    BigDecimal s = Exact.ratio(n.multiply(in).subtract(out), n.multiply(in).add(out));
    BigDecimal p = Exact.ratio(in.subtract(n.multiply(out)), in.add(n.multiply(out)));
    return Exact.square(s).add(Exact.square(p)).multiply(Exact.of(0.5));
  }

  private static double differs(double share, BigDecimal truth) {
    return Exact.toDouble(Exact.of(share).subtract(truth).abs()) / Rounding.U;
  }

  private static void critical(Tally tally) {
    Dice dice = new Dice(1);
    for (int i = 0; i < tally.times(20_000, 1_000_000); i++) {
      double eta = i % 2 == 0 ? GLASS : dice.in(1.01, 4);
      double off = dice.sign() * (i % 4 < 2 ? 1e-12 : dice.log(1e-12, 0.1));
      double cosIn = StrictMath.cos(StrictMath.asin(1 / eta) + off);
      boolean goes = through(cosIn, eta).signum() > 0;
      double cosOut = Fresnel.cosOut(cosIn, eta);
      double r = Fresnel.reflectance(cosIn, cosOut, eta);
      double t = Fresnel.transmittance(cosIn, cosOut, eta);
      tally.check(goes == off < 0);
      tally.check(goes ? cosOut > 0 && r < 1 && t > 0 : cosOut < 0 && r == 1 && t == 0);
    }
  }

  /** Rays inside a slab, at its upper face. */
  private static void transmitted(Tally tally) {
    Dice dice = new Dice(7);
    Box slab = new Box(new Vector3d(-9, -1, -9), new Vector3d(9, 0, 9));
    Tracer tracer = Glass.tracer(Glass.field().place(Placement.of(slab, Glass.of(GLASS))), 1);
    for (int i = 0; i < tally.times(5000, 100_000); i++) {
      double off = dice.sign() * (i % 2 == 0 ? 1e-12 : dice.log(1e-12, 0.1));
      double angle = StrictMath.asin(1 / GLASS) + off;
      Vector3d way = new Vector3d(StrictMath.sin(angle), StrictMath.cos(angle), 0).normalized();
      long before = tracer.counts().refraction;
      double found = Glass.red(tracer, new Vector3d(0, -0.5, 0), way);
      boolean goes = through(way.y(), GLASS).signum() > 0;
      tally.check(tracer.counts().refraction - before == (goes ? 1 : 0));
      tally.check(goes ? found > 0 : found == 0 && tracer.cut == 1);
    }
  }

  /** sin² is computed in five roundings: a wrong decision is off by no more than that. */
  private static void edge(Tally tally) {
    Dice dice = new Dice(2);
    for (int i = 0; i < tally.times(20_000, 1_000_000); i++) {
      double eta = i % 2 == 0 ? GLASS : dice.in(1.01, 4);
      double cosIn = Math.sqrt((1 - 1 / eta) * (1 + 1 / eta));
      cosIn += (dice.below(17) - 8) * Math.ulp(cosIn);
      BigDecimal truth = through(cosIn, eta);
      boolean goes = Fresnel.cosOut(cosIn, eta) > 0;
      double off = Exact.toDouble(truth.abs()) / Rounding.U;
      tally.error(goes == truth.signum() > 0 ? 0 : off);
      tally.check(true);
    }
  }

  /** Any two media side by side, as nested bodies bring them together. */
  private static void energy(Tally tally) {
    Dice dice = new Dice(3);
    for (int i = 0; i < tally.times(1_000_000, 50_000_000); i++) {
      double before = i % 3 == 0 ? 1 : dice.log(0.01, 100);
      double beyond = i % 3 == 1 ? 1 : dice.in(1, 4);
      double eta = before / beyond;
      double cosIn = cosine(dice, i % 7, eta);
      double cosOut = Fresnel.cosOut(cosIn, eta);
      double r = Fresnel.reflectance(cosIn, cosOut, eta);
      double t = Fresnel.transmittance(cosIn, cosOut, eta);
      tally.check(r >= 0 && r <= 1 && t >= 0 && t <= 1 + 8 * Rounding.U);
      tally.error(Math.abs(r + t - 1) / Rounding.U);
    }
  }

  private static double cosine(Dice dice, int kind, double eta) {
    double critical = eta > 1 ? Math.sqrt((1 - 1 / eta) * (1 + 1 / eta)) : 0.5;
    return switch (kind) {
      case 0 -> dice.in(0, 1);
      case 1 -> dice.log(1e-300, 1);
      case 2 -> 1 - dice.log(1e-16, 1);
      case 3 -> Math.min(1, critical + (dice.below(9) - 4) * Math.ulp(critical));
      case 4 -> Math.min(1, critical * (1 + dice.sign() * dice.log(1e-15, 0.1)));
      case 5 -> StrictMath.sin(1e-9);
      default -> dice.below(2);
    };
  }

  private static void back(Tally tally) {
    Dice dice = new Dice(4);
    for (int i = 0; i < tally.times(50_000, 2_000_000); i++) {
      double eta = i % 2 == 0 ? GLASS : 1 / GLASS;
      double cosIn = i % 2 == 0 ? inside(dice, 0.1) : dice.in(0.1, 1);
      tally.error(oneWay(cosIn, eta));
      tally.check(true);
    }
  }

  /**
   * As the smaller cosine c falls, its square keeps an error of 9.5u: 2.5u by rounding the larger
   * cosine, 5u by computing sin², 2u by rounding η. So c errs by 4.75u/c, and R = 1 - 5.8c by 5.8
   * times that.
   */
  private static void backFromCritical(Tally tally) {
    Dice dice = new Dice(6);
    for (int i = 0; i < tally.times(50_000, 2_000_000); i++) {
      double smaller = dice.log(1e-7, 0.1);
      double eta = i % 2 == 0 ? GLASS : 1 / GLASS;
      double cosIn = i % 2 == 0 ? Fresnel.cosOut(smaller, 1 / GLASS) : smaller;
      double error = oneWay(cosIn, eta);
      tally.error(error * smaller / Rounding.U);
      tally.check(smaller < 1e-6 || error <= 1e-8);
    }
  }

  private static double oneWay(double cosIn, double eta) {
    double cosOut = Fresnel.cosOut(cosIn, eta);
    double there = Fresnel.reflectance(cosIn, cosOut, eta);
    return Math.abs(there - reflectance(cosOut, 1 / eta));
  }

  /** The cosine inside of a ray that has at least a given one outside. */
  private static double inside(Dice dice, double least) {
    return Fresnel.cosOut(dice.in(least, 1), 1 / GLASS);
  }

  private static void grazing(Tally tally) {
    Dice dice = new Dice(5);
    for (int i = 0; i < tally.times(5000, 100_000); i++) {
      double cosIn = StrictMath.sin(i % 2 == 0 ? 1e-9 : dice.log(1e-15, 1e-6));
      double eta = 1 / (i % 2 == 0 ? GLASS : dice.in(1.01, 4));
      double r = reflectance(cosIn, eta);
      tally.check(r < 1 && r > 1 - 100 * cosIn);
      tally.error(differs(r, exactReflectance(cosIn, eta)));
    }
  }

  /** On cosines 0, 0.001, … 1: the largest differences, and where they are. */
  private static void schlick(Tally tally) {
    for (double eta : new double[] {1 / GLASS, GLASS}) {
      double most = 0;
      double where = 0;
      for (int i = 0; i <= 1000; i++) {
        double cosIn = i / 1000.0;
        double power = StrictMath.pow(1 - cosIn, 5);
        double difference = Math.abs(0.04 + 0.96 * power - reflectance(cosIn, eta));
        if (reflectance(cosIn, eta) < 1 && difference > most) {
          most = difference;
          where = cosIn;
        }
      }
      tally.check(where == (eta < 1 ? 0.088 : 0.746));
      tally.error(Math.abs(most - (eta < 1 ? 0.0357 : 0.726)));
    }
  }

  /** A floor that swallows what it refracts, under a sky of 1, shows the share by itself. */
  private static void floor(Tally tally) {
    Dice dice = new Dice(8);
    for (int i = 0; i < tally.times(500, 20_000); i++) {
      double n = i % 2 == 0 ? GLASS : dice.in(1.1, 4);
      Plane floor = new Plane(new Vector3d(0, -1, 0), Pictures.UP);
      Material black = Glass.of(n, Rgb.WHITE, 0);
      Tracer tracer = Glass.tracer(Glass.field().place(Placement.of(floor, black)), 2);
      for (int k = 0; k < 10; k++) {
        Vector3d way = new Vector3d(1, -dice.log(1e-3, 1e3), 0).normalized();
        double found = Glass.red(tracer, Vector3d.ZERO, way);
        tally.error(differs(found, exactReflectance(-way.y(), 1 / n)));
        tally.check(true);
      }
    }
  }
}
