package glint.verify;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.math.Quaternion;
import glint.math.Rounding;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Background;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.trace.Tracer;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;

/** Light that goes round and round: what is found and what is said to be cut off are all of it. */
final class EnergyCases {

  /** What a default render gives up: a twentieth of a display level at white. */
  private static final double NEGLIGIBLE = 0.05 / 255;

  private static final int DEEPEST = 32;
  private static final double[] INDICES = {1.5, 1.33, 2.4, 1.0001, 0.7};

  private EnergyCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within("A8", "a lossless ball is invisible", 1e-9, "L", EnergyCases::ball),
        HardCase.within(
            "A8-depth", "its missing light is said, depth 1..32", 132, "u", EnergyCases::shallow),
        HardCase.within(
            "A8-nested", "bodies in bodies lose nothing", 1e-12, "L", EnergyCases::nested),
        HardCase.within(
            "R11", "mirrors: what is cut off is said", 1e-12, "1", EnergyCases::mirrors),
        HardCase.within(
            "R11-box", "a mirror box, a glass ball", 1e-12, "L", EnergyCases::mirrorBox),
        HardCase.exact("R11-image", "the image's truncation holds", EnergyCases::image));
  }

  /** Impact parameters up to 0.999 r. */
  private static void ball(Tally tally) {
    Dice dice = new Dice(1);
    for (int i = 0; i < tally.times(50, 1000); i++) {
      Sphere ball = new Sphere(dice.cube(2), dice.log(0.01, 3));
      Material glass = Glass.of(i % 2 == 0 ? 1.5 : dice.in(0.5, 3));
      Tracer tracer = Glass.tracer(Glass.field().place(Placement.of(ball, glass)), 2000);
      for (int k = 0; k < 20; k++) {
        tally.error(Math.abs(1 - atBall(dice, ball, k == 0 ? 0.999 : dice.in(0, 0.999), tracer)));
        tally.check(tracer.cut <= 1e-9);
      }
    }
  }

  /** Traces a ray that passes a ball's centre at a share of its radius. */
  private static double atBall(Dice dice, Sphere ball, double share, Tracer tracer) {
    Vector3d way = dice.unit();
    Vector3d aside = dice.across(way).times(share * ball.radius());
    return Glass.red(tracer, ball.center().plus(aside).minus(way.times(20)), way);
  }

  /**
   * After n bounces (1 - R)Rⁿ⁻¹ is missing. Sums and weights of n rays err by 4u each at most, and
   * one more where the ray begins.
   */
  private static void shallow(Tally tally) {
    Dice dice = new Dice(2);
    Sphere ball = new Sphere(new Vector3d(0.1, 0.2, 0.3), 1.25);
    for (double n : INDICES) {
      Scene.Builder scene = Glass.field().place(Placement.of(ball, Glass.of(n)));
      for (int depth = 1; depth <= DEEPEST; depth++) {
        Tracer tracer = Glass.tracer(scene, depth);
        for (int k = 0; k < tally.times(10, 1000); k++) {
          double share = k == 0 ? 0.999 : dice.in(0, 0.999);
          double missing = 1 - atBall(dice, ball, share, tracer);
          tally.error(Math.abs(missing - tracer.cut) / Rounding.U);
          double cosIn = Math.sqrt((1 - share) * (1 + share));
          double r = FresnelCases.reflectance(cosIn, 1 / n);
          double series = (1 - r) * StrictMath.pow(r, depth - 1);
          tally.check(r == 1 ? missing == 0 : Math.abs(missing - series) <= 1e-9);
        }
      }
    }
  }

  /** Any bodies in and through each other: what is brought and what is cut add up to all. */
  private static void nested(Tally tally) {
    Dice dice = new Dice(3);
    for (int i = 0; i < tally.times(60, 2000); i++) {
      Scene.Builder scene = Glass.field();
      for (int k = 0; k < 6; k++) {
        Transform place =
            k % 2 == 0
                ? Transform.IDENTITY
                : Transform.rotate(Quaternion.aboutAxis(dice.unit(), dice.in(0, 360)));
        Material glass = Glass.of(dice.in(1, 2.5), Rgb.BLACK, dice.below(4));
        scene.place(new Placement(body(dice), place, glass));
      }
      Tracer tracer = new Tracer(Prepared.of(scene.build()), 24, NEGLIGIBLE);
      for (int k = 0; k < 10; k++) {
        Vector3d from = dice.unit().times(20);
        double found = Glass.red(tracer, from, dice.cube(1).minus(from));
        tally.error(Math.abs(found + tracer.cut - 1));
        tally.check(true);
      }
    }
  }

  private static Surface body(Dice dice) {
    Vector3d at = dice.cube(1);
    Vector3d other = at.plus(new Vector3d(dice.in(0.1, 2), dice.in(0.1, 2), dice.in(0.1, 2)));
    return switch (dice.below(3)) {
      case 0 -> new Sphere(at, dice.in(0.3, 2));
      case 1 -> new Box(at, other);
      default -> new Cylinder(at, other, dice.in(0.2, 1), dice.in(0, 1), true);
    };
  }

  private static final Vector3d IN = new Vector3d(0, 0, 1);

  /** Two mirrors face to face that give e and pass on k. */
  private static Scene.Builder facing(double k, double e) {
    return Glass.field()
        .background(Background.BLACK)
        .place(Placement.of(new Plane(IN.negated(), IN), Glass.mirror(k, e)))
        .place(Placement.of(new Plane(IN.times(200), IN.negated()), Glass.mirror(k, e)));
  }

  /** After D bounces e·k^(D+1)/(1 - k) is missing; without a loss there is no bound. */
  private static void mirrors(Tally tally) {
    for (double k : new double[] {0.1, 0.5, 0.9, 0.99, 0.999}) {
      for (double e : new double[] {1e-3, 0.5, 40}) {
        Scene.Builder scene = facing(k, e);
        for (int depth = 0; depth <= DEEPEST; depth++) {
          Tracer tracer = Glass.tracer(scene, depth);
          double found = Glass.red(tracer, Vector3d.ZERO, new Vector3d(0.3, 0.1, -1));
          double missing = e * StrictMath.pow(k, depth + 1) / (1 - k);
          tally.check(tracer.counts().maxDepth == depth || tracer.cut < Glass.NEGLIGIBLE);
          if (tracer.counts().maxDepth == depth) {
            tally.error(Math.abs(tracer.cut / missing - 1));
            tally.error(Math.abs((found + missing) * (1 - k) / e - 1));
          }
        }
      }
    }
    Tracer endless = Glass.tracer(facing(1, 0.25), DEEPEST);
    double found = Glass.red(endless, Vector3d.ZERO, IN);
    tally.check(found == 0.25 * (DEEPEST + 1) && endless.cut == Double.POSITIVE_INFINITY);
  }

  /** All mirrors, so that light ends only at a lamp of radiance 1: nothing else is lost. */
  private static void mirrorBox(Tally tally) {
    Dice dice = new Dice(4);
    for (int i = 0; i < tally.times(10, 200); i++) {
      Tracer tracer = new Tracer(Prepared.of(boxed(dice).build()), 64, NEGLIGIBLE);
      for (int k = 0; k < 20; k++) {
        double found = Glass.red(tracer, new Vector3d(-1.5, -1.5, -1.5), dice.unit());
        tally.error(Math.abs(found + tracer.cut - 1));
        tally.check(true);
      }
    }
  }

  private static Scene.Builder boxed(Dice dice) {
    Box walls = new Box(new Vector3d(-2, -2, -2), new Vector3d(2, 2, 2));
    Sphere ball = new Sphere(dice.cube(0.5), dice.in(0.3, 0.8));
    return Pictures.looking(new Vector3d(-1.5, -1.5, -1.5), Vector3d.ZERO, 60)
        .size(16, 12)
        .place(Placement.of(walls, Glass.mirror(1, 0)))
        .place(Placement.of(ball, Glass.of(1.5)))
        .place(Placement.of(new Sphere(new Vector3d(1.5, 1.5, 1.5), 0.4), Glass.mirror(0, 1)));
  }

  /** The truth is one radiance everywhere: what an image lacks is at most what it reports. */
  private static void image(Tally tally) {
    Scene glass =
        Glass.field().place(Placement.of(new Sphere(Vector3d.ZERO, 40), Glass.of(1.5))).build();
    Scene lamp = boxed(new Dice(5)).build();
    for (int depth = 0; depth <= DEEPEST; depth++) {
      tally.check(holds(glass, depth, 1));
      tally.check(holds(facing(0.75, 0.125).build(), depth, 0.5));
      tally.check(depth > 8 || holds(lamp, depth, 1));
      // Without a bound on the light the range of the display is the bound.
      RenderResult endless = render(facing(1, 0.01).build(), depth);
      double level = Transfer.SRGB.level(0.01 * (depth + 1));
      double most = endless.statistics().truncation();
      tally.check(Math.abs(most - (255 - level)) <= 1e-9);
    }
  }

  private static RenderResult render(Scene scene, int depth) {
    OptionalInt most = OptionalInt.of(depth);
    int tile = RenderSettings.DEFAULT_TILE;
    RenderSettings settings =
        new RenderSettings(scene.width(), scene.height(), 4, 0, most, 1, tile, Set.of());
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }

  /** Whether an image lacks no more than it says, but for its rounding. */
  private static boolean holds(Scene scene, int depth, double truth) {
    RenderResult result = render(scene, depth);
    double[] rgb = result.image().rgb();
    double sum = 0;
    for (double v : rgb) {
      double missing = Transfer.SRGB.level(truth) - Transfer.SRGB.level(v);
      sum += missing * missing;
    }
    double lacking = Math.sqrt(sum / rgb.length);
    return lacking <= result.statistics().truncation() + 1e-9;
  }
}
