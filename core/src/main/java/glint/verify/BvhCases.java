package glint.verify;

import glint.accel.Bvh;
import glint.geometry.Box;
import glint.geometry.Primitives;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Triangle;
import glint.math.BadValueException;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/** The tree finds what a scan finds, whatever lies in a slab's plane and however sizes differ. */
final class BvhCases {

  private BvhCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact("B01", "axis-parallel rays in slab planes", BvhCases::inSlabPlanes),
        HardCase.exact("B02", "rays through box corners and edges", BvhCases::touches),
        HardCase.exact("B03", "flat quads from every side", BvhCases::flatQuads),
        HardCase.exact("B04", "-0.0 in a direction is 0.0", BvhCases::minusZero),
        HardCase.exact("B05", "mixed soup: tree = scan, bit for bit", BvhCases::soup),
        HardCase.exact("B06", "float boxes hold what is below them", BvhCases::containment),
        HardCase.exact("B07", "10 000 concentric spheres", BvhCases::equalCentroids),
        HardCase.exact("B08", "no primitive, and one", BvhCases::emptyAndOne),
        HardCase.exact("B09", "r = 1e-6 beside r = 1e9: tree = scan", BvhCases::mixedScale),
        HardCase.exact("B10", "any hit before tMax = closest hit is", BvhCases::anyIsClosest),
        HardCase.exact("B13", "NaN and ∞ are refused or miss at once", BvhCases::nonFinite));
  }

  private static Box someBox(Dice dice) {
    Vector3d min = dice.cube(8);
    return new Box(min, min.plus(new Vector3d(dice.in(0.1, 3), dice.in(0.1, 3), dice.in(0.1, 3))));
  }

  /** The eye lies in two planes of a box; a comparison of doubles decides which boxes are met. */
  private static void inSlabPlanes(Tally tally) {
    Dice dice = new Dice(1);
    for (int i = 0; i < tally.times(500, 12_500); i++) {
      List<Box> boxes = new ArrayList<>();
      for (int k = 0; k < 16; k++) {
        boxes.add(someBox(dice));
      }
      Shoot shoot = Shoot.throughTree(Shoot.primitives(boxes));
      for (Box b : boxes) {
        Vector3d side = dice.below(2) == 0 ? b.min() : b.max();
        double zero = dice.sign() * 0.0;
        Vector3d o = new Vector3d(-20, side.y(), side.z());
        Vector3d d = new Vector3d(1, zero, -zero);
        double nearest = Double.POSITIVE_INFINITY;
        for (Box other : boxes) {
          boolean y = o.y() >= other.min().y() && o.y() <= other.max().y();
          boolean z = o.z() >= other.min().z() && o.z() <= other.max().z();
          nearest = y && z ? Math.min(nearest, other.min().x() + 20) : nearest;
        }
        tally.check(shoot.from(o, d) && shoot.hit.t == nearest);
      }
    }
  }

  /** Everything is a multiple of 1/8, so that the ray meets corner, edge or face exactly. */
  private static void touches(Tally tally) {
    Dice dice = new Dice(2);
    Box elsewhere = new Box(new Vector3d(90, 90, 90), new Vector3d(91, 91, 91));
    for (int i = 0; i < 50_000; i++) {
      Vector3d min = eighths(dice, 100);
      Vector3d size = eighths(dice, 15).plus(new Vector3d(2, 2, 2));
      Box box = new Box(min, min.plus(size));
      double x = dice.below(3) * 0.5;
      double y = dice.below(3) * 0.5;
      double z = x != 0.5 && y != 0.5 ? dice.below(3) * 0.5 : dice.below(2);
      Vector3d p = min.plus(new Vector3d(x * size.x(), y * size.y(), z * size.z()));
      Vector3d d = eighths(dice, 60);
      if (d.maxAbs() > 0) {
        Vector3d o = p.minus(d.times(4));
        tally.check(Shoot.at(box).from(o, d));
        Shoot tree = Shoot.throughTree(Shoot.primitives(List.of(elsewhere, box)));
        tally.check(tree.from(o, d));
      }
    }
  }

  private static Vector3d eighths(Dice dice, int range) {
    int n = 2 * range + 1;
    return new Vector3d(dice.below(n) - range, dice.below(n) - range, dice.below(n) - range)
        .times(0.125);
  }

  private static void flatQuads(Tally tally) {
    Dice dice = new Dice(3);
    Vector3d[] axes = {new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), new Vector3d(0, 0, 1)};
    List<Quad> quads = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      Vector3d e = axes[i % 3].times(dice.in(0.1, 2));
      quads.add(new Quad(dice.cube(4), e, axes[(i + 1) % 3].times(dice.in(0.1, 2))));
    }
    Soup soup = new Soup(Shoot.primitives(quads));
    for (int i = 0; i < 20_000; i++) {
      Quad q = quads.get(i % 60);
      Vector3d p = q.corner().plus(q.edge1().times(dice.in(0, 1)));
      p = p.plus(q.edge2().times(dice.in(0, 1)));
      Vector3d square = axes[(i + 2) % 3].times(dice.sign());
      Vector3d o = p.plus(i % 4 == 0 ? square : dice.unit().times(dice.log(0.1, 100)));
      tally.check(soup.agrees(o, p.minus(o)) && soup.walk.hit.found());
    }
  }

  private static void minusZero(Tally tally) {
    Dice dice = new Dice(4);
    Soup soup = new Soup(Soup.draw(dice, 200, 1));
    for (int i = 0; i < 5000; i++) {
      Vector3d o = new Vector3d(dice.in(-1, 1), dice.in(-1, 1), -5);
      boolean found = soup.walk.from(o, new Vector3d(0.0, 0.0, 1));
      double t = soup.walk.hit.t;
      int id = soup.walk.hit.primitive;
      boolean again = soup.walk.from(o, new Vector3d(-0.0, -0.0, 1));
      tally.check(again == found && soup.walk.hit.t == t && soup.walk.hit.primitive == id);
    }
  }

  private static void soup(Tally tally) {
    Dice dice = new Dice(5);
    Soup soup = new Soup(Soup.draw(dice, 1000, 3));
    for (int i = 0; i < tally.times(20_000, 100_000); i++) {
      Vector3d o = dice.cube(i % 5 == 0 ? 1e6 : 3);
      tally.check(soup.agrees(o, Soup.direction(dice, o, i)));
    }
  }

  private static void containment(Tally tally) {
    for (int i = 0; i < 20; i++) {
      Dice dice = new Dice(60 + i);
      Bvh tree = Bvh.over(Soup.draw(dice, 1000, 0.5 * i));
      // Half of scene·2⁻⁴⁰: computing the wider box in doubles has rounded, too.
      tally.check(tree.tightestMargin() >= tree.size() * 0x1p-41);
    }
  }

  private static void equalCentroids(Tally tally) {
    List<Sphere> spheres = new ArrayList<>();
    for (int i = 0; i < 10_000; i++) {
      spheres.add(new Sphere(new Vector3d(1, 2, 3), 1 + i));
    }
    Primitives primitives = Shoot.primitives(spheres);
    tally.check(Bvh.over(primitives).depth() <= 64);
    Shoot shoot = Shoot.throughTree(primitives);
    for (int i = 0; i < 10_000; i += tally.times(7, 1)) {
      Vector3d o = new Vector3d(1.5 + i, 2, 3);
      tally.check(shoot.from(o, new Vector3d(1, 0, 0)) && shoot.hit.primitive == i);
    }
  }

  private static void emptyAndOne(Tally tally) {
    Dice dice = new Dice(8);
    Shoot empty = Shoot.throughTree(Shoot.primitives(List.of()));
    Soup one = new Soup(Shoot.primitives(List.of(new Sphere(Vector3d.ZERO, 1))));
    for (int i = 0; i < 1000; i++) {
      Vector3d o = dice.cube(3);
      Vector3d d = dice.unit();
      tally.check(!empty.from(o, d) && one.agrees(o, d));
    }
  }

  private static void mixedScale(Tally tally) {
    Dice dice = new Dice(9);
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(new Sphere(new Vector3d(0, -1e9, 0), 1e9), Transform.IDENTITY, 0);
    for (int i = 1; i < 300; i++) {
      builder.add(new Sphere(dice.cube(1e-3), 1e-6), Transform.IDENTITY, i);
    }
    Soup soup = new Soup(builder.build());
    for (int i = 0; i < 20_000; i++) {
      Vector3d o = dice.cube(i % 2 == 0 ? 0.01 : 100);
      tally.check(soup.agrees(o, dice.cube(1e-3).minus(o)));
    }
  }

  private static void anyIsClosest(Tally tally) {
    Dice dice = new Dice(100);
    Soup soup = new Soup(Soup.draw(dice, 300, 3));
    for (int i = 0; i < 100_000; i++) {
      Vector3d o = dice.cube(3);
      boolean found = soup.walk.from(o, Soup.direction(dice, o, i));
      double t = soup.walk.hit.t;
      double end = found ? t * dice.in(0, 2) : dice.log(1e-3, 1e3);
      tally.check(soup.walk.any(end) == (found && t <= end));
      tally.check(soup.walk.any(t) == found && !soup.walk.any(Math.nextDown(t)));
    }
  }

  private static void nonFinite(Tally tally) {
    double[] bad = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    Dice dice = new Dice(13);
    Shoot tree = Shoot.throughTree(Soup.draw(dice, 1000, 2));
    for (double v : bad) {
      Vector3d corner = new Vector3d(0, v, 0);
      tally.check(refusesCorner(corner));
      for (int i = 0; i < 6; i++) {
        double[] ray = {5, 0.1, 0.2, -1, 0.01, 0.02};
        tree.from(new Vector3d(5, 0.1, 0.2), new Vector3d(-1, 0.01, 0.02));
        long before = tree.nodesVisited();
        tree.from(new Vector3d(5, 0.1, 0.2), new Vector3d(-1, 0.01, 0.02));
        long ordinary = tree.nodesVisited() - before;
        ray[i] = v;
        before = tree.nodesVisited();
        boolean hit =
            tree.from(new Vector3d(ray[0], ray[1], ray[2]), new Vector3d(ray[3], ray[4], ray[5]));
        tally.check(!hit && tree.nodesVisited() - before <= ordinary);
      }
    }
  }

  private static boolean refusesCorner(Vector3d corner) {
    try {
      Shoot.at(new Triangle(Vector3d.ZERO, corner, new Vector3d(1, 0, 0)));
      return false;
    } catch (BadValueException e) {
      return e.getMessage().contains("vertex 2");
    }
  }
}
