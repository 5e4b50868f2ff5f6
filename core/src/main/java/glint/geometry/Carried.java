package glint.geometry;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Transform;
import glint.math.Vector3d;

/**
 * What surfaces are in the world, under their transforms: the limits that their own numbers have
 * hold there as well, so that no kernel meets an overflow.
 */
public final class Carried {

  /** The largest factor of a transform and of its inverse: a length times it is a number. */
  private static final double LARGEST_FACTOR = 1e200;

  /** The most that a round trip may magnify rounding: 12 bits of a position are left of it. */
  private static final double MOST_MAGNIFIED = 0x1p40;

  private final Transform toWorld;
  private final double greatestFactor;
  private final double leastFactor;

  private Carried(Transform toWorld) {
    this.toWorld = toWorld;
    greatestFactor = toWorld.largest();
    leastFactor = 1 / toWorld.inverted().largest();
  }

  /**
   * Checks that a surface stays within the limits when it is carried into the world.
   *
   * @throws BadValueException if it does not
   */
  public static void check(Surface shape, Transform toWorld) {
    if (!toWorld.isIdentity()) {
      Carried carried = new Carried(toWorld);
      carried.checkTransform(shape);
      carried.checkShape(shape);
    }
  }

  private void checkTransform(Surface shape) {
    if (!(greatestFactor <= LARGEST_FACTOR && leastFactor >= 1 / LARGEST_FACTOR)) {
      throw new BadValueException("scale", "is beyond 1e200, together with other transforms");
    }
    boolean mixed = shape instanceof Sphere || shape instanceof Cylinder;
    double magnified = mixed ? toWorld.flattening() : toWorld.conditioning();
    if (!(magnified <= MOST_MAGNIFIED)) {
      throw new BadValueException(
          "scale", "flattens more than numbers are precise, by " + magnified);
    }
    point("translate", Vector3d.ZERO);
  }

  private void checkShape(Surface shape) {
    if (shape instanceof Sphere s) {
      point("center", s.center());
      length("radius", s.radius());
    } else if (shape instanceof Triangle t) {
      point("vertices", t.a());
      point("vertices", t.b());
      point("vertices", t.c());
    } else if (shape instanceof Plane p) {
      point("point", p.point());
    } else if (shape instanceof Quad q) {
      point("corner", q.corner());
      edge("edge1", q.edge1());
      edge("edge2", q.edge2());
    } else if (shape instanceof Box b) {
      Vector3d extent = b.max().minus(b.min());
      point("min", b.min());
      edge("max", new Vector3d(extent.x(), 0, 0));
      edge("max", new Vector3d(0, extent.y(), 0));
      edge("max", new Vector3d(0, 0, extent.z()));
    } else if (shape instanceof Pyramid p) {
      point("apex", p.apex());
      p.base().forEach(corner -> point("base", corner));
    } else if (shape instanceof Cylinder c) {
      Vector3d axis = c.top().minus(c.base());
      point("base", c.base());
      length("top", axis.dot(axis.normalized()));
      length("radius", c.radius());
      length("top_radius", c.topRadius());
    } else if (shape instanceof Mesh m) {
      m.corners().forEach(corner -> point("mesh", corner));
    }
  }

  private void point(String field, Vector3d p) {
    within(field, toWorld.point(p));
  }

  private void edge(String field, Vector3d edge) {
    within(field, toWorld.direction(edge));
  }

  private static void within(String field, Vector3d inWorld) {
    if (!(inWorld.maxAbs() <= Check.LARGEST)) {
      throw new BadValueException(field, "lies beyond 1e100 in the world, at " + inWorld);
    }
  }

  /** Checks a length, 0 for none, in whatever direction it may lie. */
  private void length(String field, double v) {
    if (v * greatestFactor > Check.LARGEST || v != 0 && v * leastFactor < Check.SMALLEST) {
      throw new BadValueException(
          field,
          "must be 1e-100 to 1e100 in the world, but is "
              + v * leastFactor
              + " to "
              + v * greatestFactor);
    }
  }
}
