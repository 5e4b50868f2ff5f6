package glint.scene;

import glint.geometry.Ray;
import glint.math.Vector3d;
import glint.sampling.Disc;
import glint.sampling.SobolSampler;

/**
 * A camera in front of an image of a certain size: turns places in the image into rays; scratch.
 */
public final class View {

  /** The pair of numbers that chooses a place in the lens. */
  private static final long LENS = -1;

  private final Camera camera;
  private final int width;
  private final int height;
  private final Vector3d forward;
  private final Vector3d right;
  private final Vector3d up;
  private final double halfWidth;
  private final double halfHeight;
  private final boolean parallel;
  private final double lensRadius;
  private final double focus;
  private final Disc disc = new Disc();

  /** How far behind the picture the eye of an orthographic camera is, in heights of the picture. */
  private static final double FAR_BEHIND = 1e8;

  /** Sets up the camera's frame for an image of {@code width × height} pixels. */
  public View(Camera camera, int width, int height) {
    this.camera = camera;
    this.width = width;
    this.height = height;
    forward = camera.forward();
    // Next to the zenith the cross product is not quite square to the view: twice is enough.
    Vector3d across = forward.cross(camera.up().normalized()).normalized();
    right = across.minus(forward.times(across.dot(forward))).normalized();
    up = right.cross(forward);
    halfWidth = camera.projection().halfWidth(width, height);
    halfHeight = camera.projection().halfHeight(width, height);
    parallel = camera.projection() instanceof Orthographic;
    lensRadius = camera.lens().map(Lens::radius).orElse(0.0);
    focus = camera.lens().map(Lens::focus).orElse(1.0);
  }

  /**
   * Sets {@code ray} to the ray through a random place of the lens and a place in the image.
   *
   * @param sample decides where in the lens; its middle is a pinhole
   * @return the parameter at which the far clipping plane ends the ray
   */
  public double ray(double x, double y, SobolSampler sample, Ray ray) {
    double end = ray(x, y, ray);
    if (lensRadius == 0) {
      return end;
    }
    sample.draw(LENS);
    disc.at(sample.u, sample.v);
    double a = lensRadius * disc.a;
    double b = lensRadius * disc.b;
    if (a == 0 && b == 0) {
      return end;
    }
    // Lead from the place in the lens to where the ray through its middle is sharp.
    double toFocus = focus / (ray.dx * forward.x() + ray.dy * forward.y() + ray.dz * forward.z());
    double ox = a * right.x() + b * up.x();
    double oy = a * right.y() + b * up.y();
    double oz = a * right.z() + b * up.z();
    double dx = ray.dx - ox / toFocus;
    double dy = ray.dy - oy / toFocus;
    double dz = ray.dz - oz / toFocus;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    double tMin = ray.tMin * length;
    ray.set(ray.ox + ox, ray.oy + oy, ray.oz + oz, dx / length, dy / length, dz / length);
    // The component along the view of what is added is 0: distances along it grow with the length.
    ray.tMin = tMin;
    return end * length;
  }

  /**
   * Sets {@code ray} to the ray, of unit direction, through a place in the image.
   *
   * <p>Places are antisymmetric about the middle, bit for bit, so that a mirrored scene gives a
   * mirrored image.
   *
   * @param x columns from the left edge, so that a pixel's centre is at its number plus one half
   * @param y rows from the top edge
   * @return the parameter at which the far clipping plane ends the ray
   */
  public double ray(double x, double y, Ray ray) {
    double sx = (2 * x - width) / width * halfWidth;
    double sy = (height - 2 * y) / height * halfHeight;
    double px = sx * right.x() + sy * up.x();
    double py = sx * right.y() + sy * up.y();
    double pz = sx * right.z() + sy * up.z();
    Vector3d eye = camera.position();
    if (parallel) {
      ray.set(eye.x() + px, eye.y() + py, eye.z() + pz, forward.x(), forward.y(), forward.z());
      ray.tMin = camera.near();
      return camera.far();
    }
    double dx = forward.x() + px;
    double dy = forward.y() + py;
    double dz = forward.z() + pz;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    ray.set(eye.x(), eye.y(), eye.z(), dx / length, dy / length, dz / length);
    // The component along the view is 1, so a clipping distance is reached at t = length times it.
    ray.tMin = camera.near() * length;
    return camera.far() * length;
  }

  /** Returns whether everything is in focus, as one ray through a place shows it. */
  public boolean isSharp() {
    return lensRadius == 0;
  }

  /** Returns the unit vector along the view. */
  Vector3d forward() {
    return forward;
  }

  /** Returns the unit vector that points to the right in the picture. */
  Vector3d right() {
    return right;
  }

  /** Returns the unit vector that points up in the picture. */
  Vector3d up() {
    return up;
  }

  /** Returns half the width of the picture plane: at distance 1, or in scene units. */
  double halfWidth() {
    return halfWidth;
  }

  /** Returns half the height of the picture plane: at distance 1, or in scene units. */
  double halfHeight() {
    return halfHeight;
  }

  /** Returns where it is seen from: of an orthographic camera a point far behind the picture. */
  public Vector3d eye() {
    Vector3d eye = camera.position();
    return parallel ? eye.minus(forward.times(FAR_BEHIND * halfHeight)) : eye;
  }

  /** Returns how far a point lies in front of the camera, along the view. */
  public double depth(double x, double y, double z) {
    Vector3d eye = camera.position();
    return (x - eye.x()) * forward.x() + (y - eye.y()) * forward.y() + (z - eye.z()) * forward.z();
  }

  /** Returns how wide a pixel is, in scene units, so far away as a point is. */
  public double pixel(Vector3d at) {
    double distance = parallel ? 1 : at.minus(camera.position()).length();
    return distance * 2 * halfHeight / height;
  }

  /**
   * Finds the place in the image where a point is seen, the inverse of {@link #ray}.
   *
   * @param out set to columns from the left edge and rows from the top edge; of no meaning where
   *     the depth is not more than 0
   */
  public void project(double x, double y, double z, double[] out) {
    Vector3d eye = camera.position();
    double dx = x - eye.x();
    double dy = y - eye.y();
    double dz = z - eye.z();
    double depth = parallel ? 1 : depth(x, y, z);
    double sx = (dx * right.x() + dy * right.y() + dz * right.z()) / (depth * halfWidth);
    double sy = (dx * up.x() + dy * up.y() + dz * up.z()) / (depth * halfHeight);
    out[0] = (1 + sx) * width / 2;
    out[1] = (1 - sy) * height / 2;
  }
}
