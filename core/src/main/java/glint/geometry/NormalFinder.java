package glint.geometry;

import glint.math.Vector3d;
import java.util.Arrays;

/**
 * Gives normals to corners of triangles that have none: those at one place that share get one, the
 * sum of their triangles' normals weighted by the angles there (G. Thürmer and C. Wüthrich,
 * Computing Vertex Normals from Polygonal Facets, JGT 3(1), 1998).
 *
 * <p>In the end a triangle has a normal at each of its corners, or none at all and is flat.
 */
final class NormalFinder {

  private final double[] points;
  private final int[] corners;
  private final int[] indices;
  private double[] normals;
  private int used;

  // The sums of one fan, and the normals made of them.
  private double[] sums = new double[48];
  private int[] counts = new int[16];

  /** Takes the normals that there are, of any length; one of length zero is none. */
  NormalFinder(double[] points, int[] corners, CornerValues given) {
    this.points = points;
    this.corners = corners;
    indices = new int[corners.length];
    Arrays.fill(indices, -1);
    used = 3 * given.count();
    normals = new double[used];
    for (int i = 0; i < given.count(); i++) {
      setUnit(3 * i, given.value(i, 0), given.value(i, 1), given.value(i, 2));
    }
    for (int i = 0; i < indices.length; i++) {
      boolean has = given.has(i) && !isZero(given.index(i));
      indices[i] = has ? given.index(i) : -1;
    }
  }

  private boolean isZero(int i) {
    return normals[3 * i] == 0 && normals[3 * i + 1] == 0 && normals[3 * i + 2] == 0;
  }

  /** Lets triangles of one smoothing group share; those of group 0 share with none. */
  CornerValues byGroup(int[] groups) {
    return find(groups, 0);
  }

  /** Lets triangles share that have an edge in common and meet there at less than an angle. */
  CornerValues byAngle(double degrees) {
    return find(null, StrictMath.cos(StrictMath.toRadians(degrees)));
  }

  private CornerValues find(int[] groups, double cos) {
    int count = 0;
    for (int i = 0; i < indices.length; i++) {
      count += isWanted(i, groups) ? 1 : 0;
    }
    if (count > 0) {
      int[] wanted = new int[count];
      for (int i = indices.length - 1; i >= 0; i--) {
        if (isWanted(i, groups)) {
          wanted[--count] = i;
        }
      }
      findFans(wanted, groups, cos);
    }
    completeTriangles();
    if (isFlat()) {
      return CornerValues.NONE;
    }
    boolean exact = used == normals.length;
    return new CornerValues(3, exact ? normals : Arrays.copyOf(normals, used), indices);
  }

  private boolean isWanted(int corner, int[] groups) {
    return indices[corner] < 0 && (groups == null || groups.length > 0 && groups[corner / 3] != 0);
  }

  private void findFans(int[] wanted, int[] groups, double cos) {
    int[] places = Places.of(points);
    // Sort the corners by place: the ends of places, from which they are counted down.
    int[] starts = new int[places.length + 1];
    for (int corner : wanted) {
      starts[places[corners[corner]]]++;
    }
    for (int i = 1; i < starts.length; i++) {
      starts[i] += starts[i - 1];
    }
    int[] sorted = new int[wanted.length];
    for (int i = wanted.length - 1; i >= 0; i--) {
      sorted[--starts[places[corners[wanted[i]]]]] = wanted[i];
    }
    Fan fan = new Fan(points, corners, places);
    for (int place = 0; place < places.length; place++) {
      fan.clear();
      for (int k = starts[place]; k < starts[place + 1]; k++) {
        fan.add(sorted[k]);
      }
      if (groups == null) {
        fan.shareByAngle(cos);
      } else {
        fan.shareByGroup(groups);
      }
      take(fan);
    }
  }

  /** Makes a normal for every class of several corners. */
  private void take(Fan fan) {
    if (fan.size() > counts.length) {
      counts = new int[2 * fan.size()];
      sums = new double[6 * fan.size()];
    }
    fan.sumUp(sums, counts);
    for (int i = 0; i < fan.size(); i++) {
      int shared = fan.shared(i);
      if (shared == i) {
        boolean several = counts[i] > 1;
        counts[i] = several ? put(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]) : -1;
      }
      indices[fan.corner(i)] = counts[shared];
    }
  }

  /** Adds a normal in a direction; returns its number, or -1 if the direction is zero. */
  private int put(double x, double y, double z) {
    if (used + 3 > normals.length) {
      normals = Arrays.copyOf(normals, used + Math.max(48, used / 2 / 3 * 3));
    }
    if (!setUnit(used, x, y, z)) {
      return -1;
    }
    used += 3;
    return used / 3 - 1;
  }

  /**
   * Sets a normal to the unit vector of a direction, as {@link Vector3d#normalized} does; leaves it
   * and returns false if the direction is zero.
   */
  private boolean setUnit(int at, double x, double y, double z) {
    double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    if (!(largest > 0)) {
      return false;
    }
    int exponent = Math.getExponent(largest);
    double sx = Math.scalb(x, -exponent);
    double sy = Math.scalb(y, -exponent);
    double sz = Math.scalb(z, -exponent);
    double length = Math.sqrt(sx * sx + sy * sy + sz * sz);
    normals[at] = sx / length;
    normals[at + 1] = sy / length;
    normals[at + 2] = sz / length;
    return true;
  }

  /** Gives its face's normal to what has none at a triangle of which another corner has one. */
  private void completeTriangles() {
    double[] face = new double[3];
    for (int first = 0; first < indices.length; first += 3) {
      int least = Math.min(indices[first], Math.min(indices[first + 1], indices[first + 2]));
      int most = Math.max(indices[first], Math.max(indices[first + 1], indices[first + 2]));
      if (least < 0 && most >= 0) {
        Fan.faceNormal(points, corners, first, face, 0);
        int own = put(face[0], face[1], face[2]);
        for (int i = first; i < first + 3; i++) {
          indices[i] = own < 0 || indices[i] < 0 ? own : indices[i];
        }
      }
    }
  }

  private boolean isFlat() {
    for (int index : indices) {
      if (index >= 0) {
        return false;
      }
    }
    return true;
  }
}
