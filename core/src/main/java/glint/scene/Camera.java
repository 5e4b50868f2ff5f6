package glint.scene;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Quaternion;
import glint.math.Rounding;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.Optional;

/**
 * Where the picture is taken from; immutable.
 *
 * @param position the eye
 * @param lookAt the point in the middle of the picture
 * @param up any direction that shall point up in the picture, but not along the view
 * @param projection how directions become places in the picture
 * @param near nothing nearer than this, measured along the view, is seen; 0 for no limit
 * @param far nothing farther is seen; infinite for no limit
 * @param lens what gathers light; absent for a pinhole
 */
public record Camera(
    Vector3d position,
    Vector3d lookAt,
    Vector3d up,
    Projection projection,
    double near,
    double far,
    Optional<Lens> lens) {

  /** Checks that eye, target and up span a picture and that 0 ≤ near &lt; far. */
  public Camera {
    Check.finite("position", position);
    Check.finite("look_at", lookAt);
    Check.direction("up", up);
    if (position.minus(lookAt).maxAbs() == 0) {
      throw new BadValueException("look_at", "must differ from position: " + position);
    }
    Vector3d sideways = lookAt.minus(position).normalized().cross(up.normalized());
    // Two parallel unit vectors, each rounded, have a cross product of a few roundings.
    if (sideways.maxAbs() <= Rounding.gamma(8)) {
      throw new BadValueException("up", "must not be parallel to the view direction");
    }
    if (!(near >= 0 && near < far)) {
      throw new BadValueException(
          "near", "must lie between 0 and far, but near is " + near + " and far is " + far);
    }
  }

  /** Makes a pinhole camera. */
  public Camera(
      Vector3d position,
      Vector3d lookAt,
      Vector3d up,
      Projection projection,
      double near,
      double far) {
    this(position, lookAt, up, projection, near, far, Optional.empty());
  }

  /** Returns a pinhole camera without clipping. */
  public static Camera of(Vector3d position, Vector3d lookAt, Vector3d up, Projection projection) {
    return new Camera(position, lookAt, up, projection, 0, Double.POSITIVE_INFINITY);
  }

  /** Returns the unit vector along the view. */
  Vector3d forward() {
    return lookAt.minus(position).normalized();
  }

  /**
   * Returns this camera, turned about a point.
   *
   * @throws BadValueException if it leaves the range of coordinates
   */
  Camera turned(Vector3d center, Quaternion by) {
    Transform turn = Transform.rotate(by);
    return new Camera(
        turn.direction(position.minus(center)).plus(center),
        turn.direction(lookAt.minus(center)).plus(center),
        turn.direction(up),
        projection,
        near,
        far,
        lens);
  }
}
