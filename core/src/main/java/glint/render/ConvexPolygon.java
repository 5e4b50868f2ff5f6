package glint.render;

import java.util.Arrays;

/** A convex polygon in the plane of the image, in pixels; scratch. */
final class ConvexPolygon {

  private double[] x = new double[16];
  private double[] y = new double[16];
  private int count;

  /** Where clipping writes to. */
  private double[] clippedX = new double[16];

  private double[] clippedY = new double[16];

  /** Where the last call of {@link #pick} has found a point. */
  double px;

  double py;

  void clear() {
    count = 0;
  }

  int count() {
    return count;
  }

  /** Returns whether it has no area for lack of corners. */
  boolean isEmpty() {
    return count < 3;
  }

  /** Adds a point; it is a polygon again after {@link #close}. */
  void add(double atX, double atY) {
    if (count == x.length) {
      x = Arrays.copyOf(x, 2 * count);
      y = Arrays.copyOf(y, 2 * count);
    }
    x[count] = atX;
    y[count] = atY;
    count++;
  }

  /** Adds the corners of another. */
  void add(ConvexPolygon other) {
    for (int i = 0; i < other.count; i++) {
      add(other.x[i], other.y[i]);
    }
  }

  /** Makes it so many times as large, seen from the origin. */
  void scale(double factor) {
    for (int i = 0; i < count; i++) {
      x[i] *= factor;
      y[i] *= factor;
    }
  }

  /** Makes this the convex hull of the points added (Andrew's monotone chain, 1979). */
  void close() {
    sort();
    int n = count;
    reserve(2 * n + 2);
    int hull = 0;
    for (int i = 0; i < n; i++) {
      hull = extend(hull, 0, i);
    }
    int lower = hull;
    for (int i = n - 2; i >= 0; i--) {
      hull = extend(hull, lower - 1, i);
    }
    swap();
    count = Math.max(0, hull - 1);
  }

  /** Appends a point to the hull so far, after taking back what it turns into hollows. */
  private int extend(int hull, int least, int i) {
    int end = hull;
    while (end - least >= 2 && turn(end - 2, end - 1, i) <= 0) {
      end--;
    }
    clippedX[end] = x[i];
    clippedY[end] = y[i];
    return end + 1;
  }

  private double turn(int a, int b, int i) {
    return (clippedX[b] - clippedX[a]) * (y[i] - clippedY[a])
        - (clippedY[b] - clippedY[a]) * (x[i] - clippedX[a]);
  }

  private void sort() {
    for (int i = 1; i < count; i++) {
      double movedX = x[i];
      double movedY = y[i];
      int j = i;
      for (; j > 0 && (x[j - 1] > movedX || (x[j - 1] == movedX && y[j - 1] > movedY)); j--) {
        x[j] = x[j - 1];
        y[j] = y[j - 1];
      }
      x[j] = movedX;
      y[j] = movedY;
    }
  }

  private void reserve(int size) {
    if (clippedX.length < size) {
      clippedX = new double[size];
      clippedY = new double[size];
    }
  }

  private void swap() {
    double[] otherX = x;
    double[] otherY = y;
    x = clippedX;
    y = clippedY;
    clippedX = otherX;
    clippedY = otherY;
  }

  /** Becomes the part of another within a rectangle (Sutherland and Hodgman 1974). */
  void clip(ConvexPolygon other, double left, double top, double right, double bottom) {
    clear();
    add(other);
    cut(1, 0, left);
    cut(-1, 0, -right);
    cut(0, 1, top);
    cut(0, -1, -bottom);
  }

  /** Becomes what two have in common. */
  void intersect(ConvexPolygon one, ConvexPolygon two) {
    clear();
    add(one);
    for (int i = 0; i < two.count; i++) {
      int j = i + 1 == two.count ? 0 : i + 1;
      double dx = two.x[j] - two.x[i];
      double dy = two.y[j] - two.y[i];
      cut(-dy, dx, dx * two.y[i] - dy * two.x[i]);
    }
    if (two.isEmpty()) {
      clear();
    }
  }

  /** Leaves only what lies where {@code a·x + b·y >= c}. */
  private void cut(double a, double b, double c) {
    reserve(2 * count + 2);
    int kept = 0;
    for (int i = 0; i < count; i++) {
      int j = i + 1 == count ? 0 : i + 1;
      double here = a * x[i] + b * y[i] - c;
      double there = a * x[j] + b * y[j] - c;
      if (here >= 0) {
        clippedX[kept] = x[i];
        clippedY[kept++] = y[i];
      }
      if (here > 0 && there < 0 || here < 0 && there > 0) {
        double s = here / (here - there);
        clippedX[kept] = x[i] + s * (x[j] - x[i]);
        clippedY[kept++] = y[i] + s * (y[j] - y[i]);
      }
    }
    swap();
    count = kept;
  }

  double area() {
    double twice = 0;
    for (int i = 2; i < count; i++) {
      twice += twiceArea(i);
    }
    return twice / 2;
  }

  /** Twice the area of the triangle between the first corner and the two up to one. */
  private double twiceArea(int i) {
    return (x[i - 1] - x[0]) * (y[i] - y[0]) - (y[i - 1] - y[0]) * (x[i] - x[0]);
  }

  /** Returns the least distance of two parallel lines that hold it between them. */
  double width() {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      int j = i + 1 == count ? 0 : i + 1;
      double dx = x[j] - x[i];
      double dy = y[j] - y[i];
      double most = 0;
      for (int k = 0; k < count; k++) {
        most = Math.max(most, Math.abs(dx * (y[k] - y[i]) - dy * (x[k] - x[i])));
      }
      double length = Math.sqrt(dx * dx + dy * dy);
      least = length > 0 ? Math.min(least, most / length) : least;
    }
    return least;
  }

  /** Returns whether a point lies in it or on its edge. */
  boolean contains(double atX, double atY) {
    for (int i = 0; i < count; i++) {
      int j = i + 1 == count ? 0 : i + 1;
      if ((x[j] - x[i]) * (atY - y[i]) - (y[j] - y[i]) * (atX - x[i]) < 0) {
        return false;
      }
    }
    return count >= 3;
  }

  /** Writes from where to where a row's line lies in it; turned inside out if it does not. */
  void span(double line, double[] out) {
    out[0] = Double.POSITIVE_INFINITY;
    out[1] = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      int j = i + 1 == count ? 0 : i + 1;
      double here = y[i] - line;
      double there = y[j] - line;
      if (here == 0) {
        out[0] = Math.min(out[0], x[i]);
        out[1] = Math.max(out[1], x[i]);
      } else if (here < 0 != there < 0) {
        double at = x[i] + here / (here - there) * (x[j] - x[i]);
        out[0] = Math.min(out[0], at);
        out[1] = Math.max(out[1], at);
      }
    }
  }

  double least(boolean vertical) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      least = Math.min(least, vertical ? y[i] : x[i]);
    }
    return least;
  }

  double greatest(boolean vertical) {
    double greatest = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      greatest = Math.max(greatest, vertical ? y[i] : x[i]);
    }
    return greatest;
  }

  /** Carries a point of the unit square evenly into the polygon. */
  void pick(double u, double v) {
    double left = u * 2 * area();
    int i = 2;
    while (i < count - 1 && left > twiceArea(i)) {
      left -= twiceArea(i++);
    }
    double whole = twiceArea(i);
    double root = Math.sqrt(whole > 0 ? Math.min(1, left / whole) : 0);
    double b = root * (1 - v);
    double c = root * v;
    px = x[0] + b * (x[i - 1] - x[0]) + c * (x[i] - x[0]);
    py = y[0] + b * (y[i - 1] - y[0]) + c * (y[i] - y[0]);
  }
}
