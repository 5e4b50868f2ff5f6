package glint.verify;

import glint.accel.Bvh;
import glint.geometry.Mesh;
import glint.geometry.Primitives;
import glint.geometry.Sphere;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;

/** Meshes to which rays are carried: closed as in the world, left without meeting themselves. */
final class InstanceCases {

  private static final Vector3d X = new Vector3d(1, 0, 0);

  private InstanceCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact(
            "LEAK-instance",
            "hills of 1280 triangles at scaled, mirrored, far places: at corners and edges",
            InstanceCases::leaks),
        HardCase.exact(
            "LEAVE-instance",
            "leaving convex meshes at such places outward, half grazing, half along edges",
            InstanceCases::leave),
        HardCase.exact(
            "B05-instance",
            "instances of several meshes: tree = scan, to the bit",
            InstanceCases::treeIsScan),
        HardCase.exact(
            "B06-instance",
            "outermost corners just below a float: tree = scan, to the bit",
            InstanceCases::outermost));
  }

  private static Transform turn(Dice dice) {
    return Transform.rotate(Quaternion.aboutAxis(dice.unit(), dice.in(0, 360)));
  }

  /** Scaled by factors that differ by up to {@code 1/thin}, perhaps mirrored, and turned. */
  private static Transform bent(Dice dice, double size, double thin) {
    Vector3d factors = new Vector3d(dice.sign(), dice.log(thin, 1), dice.log(thin, 1));
    return Transform.scale(factors.times(size * dice.sign())).then(turn(dice));
  }

  /** A place of any scale from 1e-6 to 1e6, flattened by up to 1e5, perhaps mirrored or far. */
  private static Transform somewhere(Dice dice) {
    double size = dice.log(1e-6, 1e6);
    double far = dice.below(3) == 0 ? 0 : size * dice.log(1e-6, 1e9);
    return bent(dice, size, dice.below(2) == 0 ? 1 : 1e-5)
        .then(Transform.translate(dice.unit().times(far)));
  }

  private static ClosedMesh moved(ClosedMesh mesh, Transform move) {
    List<Vector3d> corners = new ArrayList<>();
    mesh.corners().forEach(corner -> corners.add(move.point(corner)));
    return new ClosedMesh(corners, mesh.faces());
  }

  private static Shoot showing(Mesh mesh, Transform place) {
    Primitives.Builder builder = new Primitives.Builder();
    builder.show(mesh, place, 0, false);
    return Shoot.throughTree(builder.build());
  }

  private static void leaks(Tally tally) {
    Dice dice = new Dice(22);
    ClosedMesh hills = ClosedMesh.hills(3);
    Mesh mesh = hills.surface();
    for (int i = 0; i < tally.times(200, 4000); i++) {
      Transform place = turn(dice).then(somewhere(dice));
      Shoot shoot = showing(mesh, place);
      for (int k = 0; k < 500; k++) {
        int face = dice.below(hills.faces().size());
        Vector3d a = hills.corner(face, k);
        Vector3d edge = hills.corner(face, k + 1).minus(a);
        Vector3d to = k % 2 == 0 ? a : a.plus(edge.times(dice.in(0, 1)));
        tally.check(shoot.through(place.point(dice.ball(0.5)), place.point(to)));
      }
    }
  }

  /**
   * Turns a mesh in its own space and back again on its way into the world: so the directions of
   * scaling are none of its axes, but may be square to faces. Half of the cubes have the origin in
   * a face, where few coordinates round.
   */
  private static void leave(Tally tally) {
    Dice dice = new Dice(97);
    for (int i = 0; i < tally.times(4000, 100_000); i++) {
      Vector3d axis = dice.unit();
      double degrees = dice.in(0, 360);
      Transform own = Transform.rotate(Quaternion.aboutAxis(axis, degrees));
      Transform back = Transform.rotate(Quaternion.aboutAxis(axis, -degrees));
      Vector3d middle = i % 2 == 0 ? X : X.times(dice.log(1e-3, 1e3));
      ClosedMesh shape = i % 4 < 3 ? ClosedMesh.cube(1) : ClosedMesh.icosphere(1);
      ClosedMesh mesh = moved(shape.placed(1, middle), own);
      Transform place = back.then(somewhere(dice));
      Shoot shoot = showing(mesh.surface(), place);
      for (int k = 0; k < 20; k++) {
        Vector3d to = k % 4 < 2 ? middle.minus(X) : middle;
        Vector3d from = middle.plus(dice.unit().times(dice.log(2, 100)));
        Vector3d at = own.point(to.plus(dice.ball(dice.log(1e-9, 1))));
        if (shoot.through(place.point(own.point(from)), place.point(at))) {
          shoot.resolve();
          int face = dice.below(mesh.faces().size());
          Vector3d edge = mesh.corner(face, 1).minus(mesh.corner(face, 0));
          tally.check(!shoot.leave(outward(dice, shoot, place.direction(edge), k)));
        }
      }
    }
  }

  /** A direction away from a hit, any or all but along an edge; by 1e-6 or more, or less. */
  private static Vector3d outward(Dice dice, Shoot shoot, Vector3d edge, int k) {
    Vector3d n = shoot.normal();
    n = n.dot(shoot.direction()) > 0 ? n.negated() : n;
    Vector3d across = n.cross(edge.normalized());
    boolean any = k % 3 == 0 || across.length() < 1e-3;
    Vector3d along = any ? dice.across(n) : across.normalized().cross(n);
    double rise = k % 2 == 0 ? dice.log(1e-14, 1e-6) : dice.in(1e-6, 1);
    return along.plus(n.times(rise)).times(dice.power(20));
  }

  private static void treeIsScan(Tally tally) {
    Dice dice = new Dice(55);
    ClosedMesh[] meshes = {ClosedMesh.cube(1), ClosedMesh.hills(2)};
    Mesh[] surfaces = {meshes[0].surface(), meshes[1].surface()};
    for (int i = 0; i < tally.times(20, 400); i++) {
      Primitives.Builder builder = new Primitives.Builder();
      List<Vector3d> targets = new ArrayList<>();
      for (int k = 0; k < 40; k++) {
        Transform place =
            turn(dice)
                .then(bent(dice, dice.log(0.1, 10), 1e-3))
                .then(Transform.translate(dice.cube(10)));
        if (k % 4 == 0) {
          builder.add(surfaces[0], place, k);
        } else {
          builder.show(surfaces[k % 2], place, k, false);
        }
        meshes[k % 2].corners().forEach(corner -> targets.add(place.point(corner)));
      }
      Primitives primitives = builder.build();
      Shoot scan = Shoot.scanning(primitives);
      Shoot tree = Shoot.through(Bvh.over(primitives));
      for (int k = 0; k < 100; k++) {
        Vector3d d = dice.unit().times(dice.log(1, 100));
        tally.check(isSame(scan, tree, targets.get(dice.below(targets.size())).minus(d), d));
      }
    }
  }

  /**
   * Touches a cube at its outermost corner, or all but touches it, with rays across the axis:
   * rounding decides. Its box is such that its rounding to floats hides nothing.
   */
  private static void outermost(Tally tally) {
    Dice dice = new Dice(56);
    for (int i = 0; i < tally.times(2000, 50_000); i++) {
      boolean far = i % 2 == 0;
      Vector3d middle = dice.unit().times(far ? dice.log(1e5, 1e7) : 0);
      ClosedMesh cube = ClosedMesh.cube(1).placed(1, middle);
      Transform bent = turn(dice).then(bent(dice, 1, far ? 1 : 1e-5));
      Transform place = bent.then(Transform.translate(bent.point(middle).negated()));
      Primitives primitives = null;
      for (int k = 0; k < 4; k++) {
        Primitives.Builder builder = new Primitives.Builder();
        builder.show(cube.surface(), place, 0, false);
        for (int s = 0; s < 4; s++) {
          Vector3d at = new Vector3d(0, s % 2 == 0 ? 15 : -15, s < 2 ? 15 : -15);
          builder.add(new Sphere(at, 1), Transform.IDENTITY, 1 + s);
        }
        primitives = builder.build();
        double[] box = new double[6];
        primitives.bounds(0, box);
        double margin = 16 * 0x1p-40;
        place = place.then(Transform.translate(X.times(8 - 1.01 * margin - box[3])));
      }
      Transform last = place;
      Vector3d to = Collections.max(cube.corners(), Comparator.comparing(c -> last.point(c).x()));
      Shoot scan = Shoot.scanning(primitives);
      Shoot tree = Shoot.through(Bvh.over(primitives));
      for (int k = 0; k < 20; k++) {
        Vector3d d = dice.across(X).times(dice.log(1, 1e6));
        Vector3d beside = X.times(dice.below(2) * dice.log(1e-13, 1e-4));
        tally.check(isSame(scan, tree, place.point(to).plus(beside).minus(d), d));
      }
    }
  }

  private static boolean isSame(Shoot scan, Shoot tree, Vector3d o, Vector3d d) {
    boolean found = scan.from(o, d);
    boolean same = tree.from(o, d) == found && tree.any(scan.hit.t) == found;
    if (found && same) {
      scan.resolve();
      tree.resolve();
      same = scan.hit.t == tree.hit.t && scan.hit.surface == tree.hit.surface;
      same &= scan.hit.crossing == tree.hit.crossing;
      same &= scan.point().equals(tree.point()) && scan.normal().equals(tree.normal());
    }
    return same;
  }
}
