package glint.models.shape;

import glint.math.Transform;
import glint.math.Vector3d;

/**
 * A body as a function: below 0 inside, above outside, near the surface about the distance to it.
 *
 * <p>Source of the shapes and of the smooth minimum: I. Quilez, Distance Functions and Smooth
 * Minimum, iquilezles.org.
 */
@FunctionalInterface
public interface Solid {

  /** Returns the value at a point. */
  double at(Vector3d p);

  /** Returns an ellipsoid. */
  static Solid ellipsoid(Vector3d center, Vector3d radii) {
    return p -> {
      double x = (p.x() - center.x()) / radii.x();
      double y = (p.y() - center.y()) / radii.y();
      double z = (p.z() - center.z()) / radii.z();
      double share = Math.sqrt(x * x + y * y + z * z);
      Vector3d slope = new Vector3d(x / radii.x(), y / radii.y(), z / radii.z());
      double least = Math.min(radii.x(), Math.min(radii.y(), radii.z()));
      return share > 0.01 ? share * (share - 1) / slope.length() : -least;
    };
  }

  /** Returns a capsule whose radius goes from one to another. */
  static Solid capsule(Vector3d from, Vector3d to, double fromRadius, double toRadius) {
    Vector3d axis = to.minus(from);
    double square = axis.dot(axis);
    return p -> {
      Vector3d away = p.minus(from);
      double share = Math.max(0, Math.min(1, away.dot(axis) / square));
      double radius = fromRadius + (toRadius - fromRadius) * share;
      return away.minus(axis.times(share)).length() - radius;
    };
  }

  /** Returns a box around the origin, of half these extents, its edges rounded. */
  static Solid box(Vector3d half, double rounding) {
    return p -> {
      double x = Math.abs(p.x()) - half.x() + rounding;
      double y = Math.abs(p.y()) - half.y() + rounding;
      double z = Math.abs(p.z()) - half.z() + rounding;
      double outside = new Vector3d(Math.max(x, 0), Math.max(y, 0), Math.max(z, 0)).length();
      return outside + Math.min(Math.max(x, Math.max(y, z)), 0) - rounding;
    };
  }

  /** Returns this body joined with another, the seam filled over a width. */
  default Solid with(Solid other, double width) {
    return p -> smoothMin(at(p), other.at(p), width);
  }

  /** Returns what another body leaves of this one, the edge rounded over a width. */
  default Solid without(Solid other, double width) {
    return p -> -smoothMin(-at(p), other.at(p), width);
  }

  /** Returns this body turned and moved; the transform does not scale. */
  default Solid moved(Transform transform) {
    Transform back = transform.inverted();
    return p -> at(back.point(p));
  }

  /** Returns the half where x is positive, and its mirror image. */
  default Solid mirrored() {
    return p -> at(new Vector3d(Math.abs(p.x()), p.y(), p.z()));
  }

  private static double smoothMin(double a, double b, double width) {
    double near = width > 0 ? Math.max(width - Math.abs(a - b), 0) / width : 0;
    return Math.min(a, b) - near * near * width / 4;
  }
}
