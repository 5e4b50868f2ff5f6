package glint.verify;

import glint.accel.Bvh;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Plane;
import glint.geometry.Primitives;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;

/** Many surfaces of every kind and size, with and without a tree. */
final class Soup {

  final Bvh tree;
  final Shoot scan;
  final Shoot walk;

  Soup(Primitives primitives) {
    tree = Bvh.over(primitives);
    scan = Shoot.scanning(primitives);
    walk = Shoot.through(tree);
  }

  /**
   * Draws a soup around the origin.
   *
   * @param orders over how many orders of magnitude sizes spread, from 1 downward
   */
  static Primitives draw(Dice dice, int count, double orders) {
    Primitives.Builder builder = new Primitives.Builder();
    for (int i = 0; i < count; i++) {
      double size = StrictMath.pow(10, -orders * dice.in(0, 1));
      Transform place = Transform.translate(dice.cube(1.5));
      if (i % 3 == 0) {
        Transform squash = Transform.scale(new Vector3d(1, dice.in(0.2, 1.2), 1));
        Quaternion turn = Quaternion.aboutAxis(dice.unit(), dice.in(0, 360));
        place = squash.then(Transform.rotate(turn)).then(place);
      }
      builder.add(shape(dice, i, size), place, i);
    }
    return builder.build();
  }

  private static Surface shape(Dice dice, int i, double size) {
    Vector3d corner = new Vector3d(size, 0.5 * size, size);
    return switch (i % 7) {
      case 0, 1 -> new Sphere(Vector3d.ZERO, size);
      case 2 -> new Box(corner.negated(), corner);
      case 3 -> {
        Vector3d top = dice.unit().times(size);
        yield new Cylinder(Vector3d.ZERO, top, size, dice.below(2) * 0.3 * size, i % 2 == 0);
      }
      case 4 -> new Quad(Vector3d.ZERO, new Vector3d(size, 0, 0), new Vector3d(0, 0, size));
      case 5 -> i < 12 ? new Plane(dice.cube(9), dice.unit()) : new Sphere(Vector3d.ZERO, size);
      default -> new Triangle(dice.cube(size), dice.cube(size), dice.cube(size));
    };
  }

  /** A ray towards the middle; every third one runs along axes, with zeros of both signs. */
  static Vector3d direction(Dice dice, Vector3d o, int i) {
    Vector3d d = dice.cube(1).minus(o);
    return switch (i % 9) {
      case 0 -> new Vector3d(0.0, -0.0, d.z());
      case 3 -> new Vector3d(-0.0, d.y(), 0.0);
      case 6 -> new Vector3d(d.x(), 0.0, -0.0);
      default -> d;
    };
  }

  /** Returns whether tree and scan find the same, bit for bit. */
  boolean agrees(Vector3d o, Vector3d d) {
    boolean found = scan.from(o, d);
    boolean same = walk.from(o, d) == found;
    return same && scan.hit.primitive == walk.hit.primitive && scan.hit.t == walk.hit.t;
  }
}
