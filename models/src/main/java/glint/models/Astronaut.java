package glint.models;

import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.models.shape.Lathe;
import glint.models.shape.Shape;
import glint.models.shape.Solid;
import glint.models.shape.Spline;
import glint.models.shape.Superellipsoid;
import glint.models.shape.SurfaceNets;
import glint.models.shape.Sweep;
import java.util.List;

/** An astronaut adrift, 2 m from boots to helmet; y is up, z forward, one arm reaches out. */
final class Astronaut {

  private static final double CELL = 0.051;
  private static final double FINGER_CELL = 0.025;

  private static final Vector3d RIGHT_SHOULDER = at(0.27, 1.36, 0);
  private static final Vector3d RIGHT_ELBOW = at(0.53, 1.52, 0.16);
  private static final Vector3d RIGHT_WRIST = at(0.74, 1.76, 0.36);
  private static final Vector3d LEFT_SHOULDER = at(-0.27, 1.34, 0);
  private static final Vector3d LEFT_ELBOW = at(-0.52, 1.14, 0.06);
  private static final Vector3d LEFT_WRIST = at(-0.72, 1.0, 0.3);

  private static final Paint CLOTH = Paint.dull("cloth", 0.72, 0.71, 0.69).shiny(0.05, 12);
  private static final Paint RED = Paint.dull("red", 0.55, 0.05, 0.03);
  private static final Paint GREY = Paint.dull("grey", 0.2, 0.21, 0.23).shiny(0.15, 30);
  private static final Paint SHELL = Paint.dull("shell", 0.75, 0.75, 0.76).shiny(0.4, 120);
  private static final Paint GOLD =
      Paint.dull("visor", 0.05, 0.03, 0.008).mirror(0.82, 0.58, 0.26, 400);
  private static final Paint LAMP = Paint.dull("lamp", 0, 0, 0).glowing(1.2, 1.3, 1.4);
  private static final Paint CORD = Paint.dull("cord", 0.75, 0.4, 0.08);

  private Astronaut() {}

  static Model model() {
    Shape suit = SurfaceNets.of(suit(), at(-0.95, -0.15, -0.5), at(0.95, 1.9, 0.6), CELL);
    Model model =
        new Model()
            .add(CLOTH, suit)
            .add(RED, band(RIGHT_SHOULDER, RIGHT_ELBOW, 0.13))
            .add(RED, band(LEFT_SHOULDER, LEFT_ELBOW, 0.13))
            .add(GREY, hand(RIGHT_ELBOW, RIGHT_WRIST, 1))
            .add(GREY, hand(LEFT_ELBOW, LEFT_WRIST, -1));
    helmet(model);
    pack(model);
    return model.add(CORD, cord());
  }

  private static Solid suit() {
    Solid trunk = Solid.capsule(at(0, 0.98, 0), at(0, 1.3, 0), 0.235, 0.25);
    Solid hips = Solid.ellipsoid(at(0, 0.86, 0), at(0.25, 0.2, 0.2));
    Solid shoulders = Solid.capsule(at(-0.2, 1.37, 0), at(0.2, 1.37, 0), 0.15, 0.15);
    Solid body = trunk.with(hips, 0.12).with(shoulders, 0.12);
    Solid right = limb(RIGHT_SHOULDER, RIGHT_ELBOW, RIGHT_WRIST, 0.13, 0.095);
    Solid left = limb(LEFT_SHOULDER, LEFT_ELBOW, LEFT_WRIST, 0.13, 0.095);
    Solid rightLeg =
        limb(at(0.13, 0.82, 0), at(0.19, 0.44, 0.15), at(0.2, 0.08, -0.08), 0.17, 0.125);
    Solid leftLeg =
        limb(at(-0.13, 0.82, 0), at(-0.17, 0.47, 0.24), at(-0.19, 0.24, -0.12), 0.17, 0.125);
    Solid boots = boot(0.2, 0.02, -0.06, 25).with(boot(-0.19, 0.17, -0.15, 60), 0);
    return body.with(right, 0.05)
        .with(left, 0.05)
        .with(rightLeg.with(leftLeg, 0), 0.06)
        .with(boots, 0.03);
  }

  /** An arm or a leg: two capsules with folds in the cloth. */
  private static Solid limb(Vector3d from, Vector3d joint, Vector3d to, double thick, double thin) {
    double middle = (thick + thin) / 2;
    Solid upper = folded(Solid.capsule(from, joint, thick, middle), from, joint);
    Solid lower = folded(Solid.capsule(joint, to, middle, thin), joint, to);
    return upper.with(lower, 0.05);
  }

  private static Solid folded(Solid solid, Vector3d from, Vector3d to) {
    Vector3d along = to.minus(from).normalized();
    return p -> solid.at(p) + 0.007 * StrictMath.sin(58 * p.minus(from).dot(along));
  }

  private static Solid boot(double x, double y, double z, double tilt) {
    Solid sole = Solid.box(at(0.105, 0.085, 0.19), 0.07);
    return sole.moved(Transform.rotate(Quaternion.aboutAxis(at(1, 0, 0), tilt)))
        .moved(Transform.translate(at(x, y, z + 0.06)));
  }

  /** A band around the upper part of a limb. */
  private static Shape band(Vector3d from, Vector3d to, double radius) {
    Vector3d axis = to.minus(from);
    List<Vector3d> path = List.of(from.plus(axis.times(0.55)), from.plus(axis.times(0.8)));
    return Sweep.tube(path, 24, t -> radius);
  }

  /** A glove with its fingers a little apart; side is 1 for the right hand. */
  private static Shape hand(Vector3d elbow, Vector3d wrist, int side) {
    Vector3d along = wrist.minus(elbow).normalized();
    Vector3d across = along.cross(at(0, 0.3, -1)).normalized().times(side);
    Vector3d palm = wrist.plus(along.times(0.09));
    Solid hand =
        Solid.capsule(wrist.minus(along.times(0.03)), wrist, 0.105, 0.1)
            .with(Solid.capsule(palm, palm.plus(along.times(0.05)), 0.07, 0.065), 0.05);
    for (int i = 0; i < 4; i++) {
      double spread = (i - 1.5) * 0.036;
      Vector3d knuckle = palm.plus(along.times(0.07)).plus(across.times(spread));
      Vector3d tip =
          knuckle
              .plus(along.times(0.13 - 0.012 * Math.abs(i - 1.3)))
              .plus(across.times(0.9 * spread))
              .plus(at(0, 0, 0.03));
      hand = hand.with(Solid.capsule(knuckle, tip, 0.026, 0.021), 0.015);
    }
    Vector3d thumb = palm.minus(across.times(0.06));
    hand =
        hand.with(
            Solid.capsule(
                thumb, thumb.minus(across.times(0.07)).plus(along.times(0.06)), 0.03, 0.024),
            0.02);
    Vector3d reach = at(0.3, 0.3, 0.3);
    return SurfaceNets.of(hand, palm.minus(reach), palm.plus(reach), FINGER_CELL);
  }

  private static void helmet(Model model) {
    Shape ball = Superellipsoid.of(at(0.225, 0.235, 0.24), 0.92, 24, 16);
    Shape visor = Superellipsoid.of(at(0.185, 0.17, 0.2), 0.85, 28, 18);
    Shape ring = Lathe.tube(28, 0.15, 0, 0.2, 0.0, 0.215, 0.03, 0.2, 0.06, 0.15, 0.06);
    model.add(SHELL, ball.moved(0, 1.7, 0.0)).add(GOLD, visor.moved(0, 1.705, 0.075));
    model.add(GREY, ring.moved(0, 1.45, 0));
    for (int side = -1; side <= 1; side += 2) {
      model.add(SHELL, box(0.225 * side, 1.78, 0.06, 0.035, 0.045, 0.06));
      model.add(LAMP, box(0.225 * side, 1.78, 0.12, 0.022, 0.03, 0.008));
    }
  }

  private static void pack(Model model) {
    model.add(SHELL, box(0, 1.2, -0.36, 0.27, 0.37, 0.15));
    model.add(GREY, box(0, 1.2, -0.5, 0.17, 0.26, 0.04));
    model.add(GREY, box(0, 0.86, -0.33, 0.2, 0.06, 0.12));
    model.add(SHELL, box(0, 1.2, 0.27, 0.14, 0.09, 0.06));
    model.add(RED, box(-0.07, 1.22, 0.33, 0.025, 0.025, 0.012));
    model.add(GREY, box(0.04, 1.22, 0.33, 0.05, 0.025, 0.012));
    for (int side = -1; side <= 1; side += 2) {
      List<Vector3d> hose =
          Spline.through(
              5,
              at(0.1 * side, 1.2, 0.3),
              at(0.22 * side, 1.12, 0.24),
              at(0.29 * side, 1.2, 0),
              at(0.26 * side, 1.25, -0.25));
      model.add(GREY, Sweep.tube(hose, 8, t -> 0.024));
    }
  }

  /** The safety line, torn: it trails from the belt. */
  private static Shape cord() {
    List<Vector3d> path =
        Spline.through(
            8,
            at(-0.2, 0.92, 0.1),
            at(-0.42, 0.75, 0.25),
            at(-0.62, 0.35, 0.1),
            at(-0.5, -0.1, -0.1),
            at(-0.85, -0.4, 0.05),
            at(-1.25, -0.25, 0.2),
            at(-1.4, -0.6, 0.15));
    return Sweep.tube(path, 7, t -> 0.017);
  }

  private static Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return Superellipsoid.of(at(dx, dy, dz), 0.25, 12, 8).moved(x, y, z);
  }

  private static Vector3d at(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }
}
