package glint.accel;

import glint.geometry.Primitives;
import glint.geometry.Ray;
import glint.math.Vector3d;

/**
 * Rays that share an end or a direction, and short lists of what each can meet; immutable.
 *
 * <p>The directions from a point are the places on the six faces of a cube around it; parallel rays
 * are told apart by where they meet a plane. In either way a widened box covers at most a
 * rectangle, and a ray meets no box but those that are seen at its own place. Source: E. Haines, D.
 * Greenberg, The Light Buffer: A Shadow-Testing Accelerator, 1986.
 */
public final class Pencil {

  /** Rays may begin this many times as far away as things are. */
  private static final double FAR = 0x1p16;

  /** What is left out must be farther by this share, for {@link Intersector#isAlone}. */
  private static final double SORTED = 0x1p-18;

  /** The point, or the direction. */
  private final double px;

  private final double py;
  private final double pz;

  private final boolean parallel;

  /** Whether the point is where rays begin, not where they end. */
  private final boolean begins;

  /** No coordinate of where a ray begins is larger. */
  private final double reach;

  /** Of a direction, the axis it leads along most, and its slopes along the two after it. */
  private final int axis;

  private final double slopeV;
  private final double slopeW;

  private final Cells cells;

  /** The slot of the first box, where lists are of primitives. */
  private final int first;

  /** Where the boxes of the subtrees begin that lists are of, or null. */
  private final int[] places;

  /**
   * Makes lists of boxes that are wider than the tree's by what a hit may lie off its primitive and
   * a ray off its place (see docs/numerics.md).
   */
  private Pencil(Vector3d p, boolean parallel, boolean begins, Primitives primitives, Parts parts) {
    px = p.x();
    py = p.y();
    pz = p.z();
    this.parallel = parallel;
    this.begins = begins;
    axis = axis(px, py, pz);
    slopeV = component(p, axis + 1) / component(p, axis);
    slopeW = component(p, axis + 2) / component(p, axis);
    first = primitives.unbounded();
    double size = parts == null ? Boxes.largestCoordinate(primitives) : parts.size();
    double away = parallel ? size : Math.max(size, p.maxAbs());
    double farthest = begins && !parallel ? away : FAR * away;
    double margin =
        size * Boxes.MARGIN + Slabs.SLACK * primitives.conditioning() * (size + farthest);
    reach = margin < Double.POSITIVE_INFINITY ? farthest : Double.NaN; // else no ray is near enough
    places = parts == null ? null : parts.sorted(p, parallel);
    int count = parts == null ? primitives.count() - first : places.length;
    double[][] near = new double[parallel ? 1 : 6][count];
    cells = new Cells(seen(primitives, parts, p, margin, near), near);
  }

  /**
   * Makes lists for rays from a point.
   *
   * @param parts of which lists are to be made in place of primitives, or null
   */
  public static Pencil from(Vector3d point, Primitives primitives, Parts parts) {
    return new Pencil(point, false, true, primitives, parts);
  }

  /**
   * Makes lists for rays to a point, which end there: with the difference of point and origin, or a
   * power of two times it, for a direction.
   *
   * @param parts of which lists are to be made in place of primitives, or null
   */
  public static Pencil to(Vector3d point, Primitives primitives, Parts parts) {
    return new Pencil(point, false, false, primitives, parts);
  }

  /**
   * Makes lists for rays of one direction, not zero.
   *
   * @param parts of which lists are to be made in place of primitives, or null
   */
  public static Pencil along(Vector3d direction, Primitives primitives, Parts parts) {
    return new Pencil(direction, true, true, primitives, parts);
  }

  /** Finds, by face, the rectangles of the boxes of what lists are of, wider by a margin. */
  private double[][] seen(
      Primitives primitives, Parts parts, Vector3d p, double margin, double[][] near) {
    int count = near[0].length;
    double[][] seen = new double[near.length][4 * count];
    double[] box = new double[6];
    for (int i = 0; i < count; i++) {
      if (parts == null) {
        primitives.bounds(first + i, box);
      } else {
        parts.bounds(places[i], box);
      }
      for (int a = 0; a < 3; a++) {
        double from = parallel ? 0 : component(p, a);
        box[a] = box[a] - margin - from;
        box[3 + a] = box[3 + a] + margin - from;
      }
      for (int face = 0; face < seen.length; face++) {
        near[face][i] = parallel ? i : (1 - SORTED) * near(box, face);
        for (int k = 0; k < 2; k++) {
          if (parallel) {
            shift(box, k, seen[face], 4 * i + 2 * k);
          } else {
            project(box, face, k, seen[face], 4 * i + 2 * k);
          }
        }
      }
    }
    return seen;
  }

  /**
   * Finds the range of a coordinate of a box where the direction carries it to a plane; one without
   * a bound where that is not a number, because no float is as large as the box.
   */
  private void shift(double[] box, int k, double[] out, int at) {
    int a = (axis + 1 + k) % 3;
    double slope = k == 0 ? slopeV : slopeW;
    double one = box[axis] * slope;
    double other = box[3 + axis] * slope;
    double least = box[a] - Math.max(one, other);
    double greatest = box[3 + a] - Math.min(one, other);
    out[at] = least > Double.NEGATIVE_INFINITY ? least : Double.NEGATIVE_INFINITY;
    out[at + 1] = greatest < Double.POSITIVE_INFINITY ? greatest : Double.POSITIVE_INFINITY;
  }

  /**
   * Finds the range of a coordinate, on a face of a cube around the origin, of a box as it is seen
   * from there.
   *
   * <p>A quotient is as monotonic as a ray's own, so that nothing is lost by rounding; where it is
   * not a number, because the box reaches the origin, the range has no bound.
   */
  private static void project(double[] box, int face, int k, double[] out, int at) {
    int depth = face >> 1;
    boolean up = (face & 1) == 1;
    double near = near(box, face);
    double far = up ? box[3 + depth] : -box[depth];
    int a = (depth + 1 + k) % 3;
    double least = box[a] / (box[a] < 0 ? near : far);
    double greatest = box[3 + a] / (box[3 + a] > 0 ? near : far);
    out[at] = far < 0 ? 1 : least > -1 ? least : -1;
    out[at + 1] = far < 0 ? -1 : greatest < 1 ? greatest : 1;
  }

  /** Returns how far from the origin, along the axis of a face, a box begins. */
  private static double near(double[] box, int face) {
    return Math.max(0, (face & 1) == 1 ? box[face >> 1] : -box[3 + (face >> 1)]);
  }

  /**
   * Returns how many times its parameter a ray from the point gets away from it along an axis; 0
   * where lists are not for that.
   */
  double depthPerT(Ray ray) {
    return begins && !parallel ? largest(ray.dx, ray.dy, ray.dz) : 0;
  }

  /** Returns how far from the point, along an axis, a ray to it begins; all else has no bound. */
  double begin(Ray ray) {
    return begins ? Double.POSITIVE_INFINITY : largest(px - ray.ox, py - ray.oy, pz - ray.oz);
  }

  private static double largest(double x, double y, double z) {
    return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
  }

  /** Returns how far from the point, along an axis, what is at a place in the lists begins. */
  float depth(int place) {
    return cells.depth(place);
  }

  /**
   * Returns the list for a ray, or {@link Cells#MANY}, which a ray gets that is not one of them.
   */
  int list(Ray ray) {
    if (!holds(ray)) {
      return Cells.MANY;
    }
    if (parallel) {
      return listAlong(ray);
    }
    double x = begins ? ray.dx : -ray.dx;
    double y = begins ? ray.dy : -ray.dy;
    double z = begins ? ray.dz : -ray.dz;
    double ax = Math.abs(x);
    double ay = Math.abs(y);
    double az = Math.abs(z);
    if (ax >= ay && ax >= az) {
      return cells.list(x > 0 ? 1 : 0, y / ax, z / ax);
    }
    if (ay >= az) {
      return cells.list(y > 0 ? 3 : 2, z / ay, x / ay);
    }
    return cells.list(z > 0 ? 5 : 4, x / az, y / az);
  }

  private int listAlong(Ray ray) {
    return switch (axis) {
      case 0 -> cells.list(0, ray.oy - ray.ox * slopeV, ray.oz - ray.ox * slopeW);
      case 1 -> cells.list(0, ray.oz - ray.oy * slopeV, ray.ox - ray.oy * slopeW);
      default -> cells.list(0, ray.ox - ray.oz * slopeV, ray.oy - ray.oz * slopeW);
    };
  }

  /** Returns whether a ray is one of these, as far as that can be told. */
  private boolean holds(Ray ray) {
    if (begins && !parallel) {
      return ray.ox == px && ray.oy == py && ray.oz == pz;
    }
    double far = Math.max(Math.abs(ray.ox), Math.max(Math.abs(ray.oy), Math.abs(ray.oz)));
    return far <= reach && (!parallel || (ray.dx == px && ray.dy == py && ray.dz == pz));
  }

  /** Returns the slot of the primitive at a place in the lists. */
  int slot(int place) {
    return first + cells.box(place);
  }

  /** Returns whether the lists are of subtrees, not of primitives. */
  boolean inParts() {
    return places != null;
  }

  /** Returns where the box of the subtree at a place in the lists begins. */
  int part(int place) {
    return places[cells.box(place)];
  }

  private static int axis(double x, double y, double z) {
    double ax = Math.abs(x);
    double ay = Math.abs(y);
    double az = Math.abs(z);
    return ax >= ay && ax >= az ? 0 : ay >= az ? 1 : 2;
  }

  private static double component(Vector3d v, int i) {
    return switch (i % 3) {
      case 0 -> v.x();
      case 1 -> v.y();
      default -> v.z();
    };
  }
}
