package glint.scene;

import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.Optional;

/**
 * A camera in someone's hands: the cameras that moves of it lead to; immutable.
 *
 * <p>It goes about its target, the point that it looks at. No direction is special to it, so that
 * it turns over the poles as anywhere else; the {@code up} of what it returns is exactly that of
 * the picture. Every method throws {@link glint.math.BadValueException} where it would leave the
 * range of coordinates.
 *
 * @param camera where it is
 * @param width columns of the picture in which places are meant
 * @param height rows of that
 */
public record Handheld(Camera camera, int width, int height) {

  /**
   * Goes about the target as if the world were a ball under the hand: what is at one place of its
   * front comes to another by twice the turn (Shoemake 1992, ARCBALL).
   *
   * <p>The ball touches the nearer sides of the picture; outside of it the picture rolls. All of a
   * drag is told from its beginning, so that one that returns leads back.
   *
   * @param fromX columns from the left edge
   * @param fromY rows from the top edge
   */
  public Camera orbited(double fromX, double fromY, double toX, double toY) {
    View view = view();
    Vector3d a = onBall(fromX, fromY);
    Vector3d b = onBall(toX, toY);
    Vector3d axis = inWorld(view, b.cross(a));
    return turned(view, new Quaternion(a.dot(b), axis.x(), axis.y(), axis.z()));
  }

  /** Rolls, so that the picture turns clockwise by so many degrees. */
  public Camera rolled(double degrees) {
    View view = view();
    return turned(view, Quaternion.aboutAxis(view.forward(), -degrees));
  }

  /** Moves across the view, so that what is as far as the target moves by so many pixels. */
  public Camera panned(double columns, double rows) {
    View view = view();
    double distance = camera.projection() instanceof Orthographic ? 1 : distance();
    double x = -2 * columns / width * view.halfWidth() * distance;
    double y = 2 * rows / height * view.halfHeight() * distance;
    Vector3d way = view.right().times(x).plus(view.up().times(y));
    return placed(camera.position().plus(way), camera.lookAt().plus(way), view.up());
  }

  /**
   * Moves along the view, to {@code factor} times the distance of the target; with parallel rays
   * shows as many times as much.
   */
  public Camera dollied(double factor) {
    if (camera.projection() instanceof Orthographic parallel) {
      return with(
          camera.position(),
          camera.lookAt(),
          view().up(),
          new Orthographic(factor * parallel.planeHeight()));
    }
    Vector3d way = camera.position().minus(camera.lookAt()).times(factor);
    return placed(camera.lookAt().plus(way), camera.lookAt(), view().up());
  }

  /**
   * Takes a point for the target: turns to it by the shortest way, or, with parallel rays, moves
   * before it.
   */
  public Camera aimed(Vector3d point) {
    View view = view();
    Vector3d eye = camera.position();
    if (camera.projection() instanceof Orthographic) {
      Vector3d back = view.forward().times(distance());
      return placed(point.minus(back), point, view.up());
    }
    if (point.equals(eye)) {
      return placed(eye, point, view.up());
    }
    // The turn from one direction to another is by twice the way to their middle.
    Vector3d middle = view.forward().plus(point.minus(eye).normalized());
    Vector3d half = middle.maxAbs() > 0 ? middle.normalized() : view.right();
    Vector3d axis = view.forward().cross(half);
    Quaternion turn = new Quaternion(view.forward().dot(half), axis.x(), axis.y(), axis.z());
    return placed(eye, point, Transform.rotate(turn).direction(view.up()));
  }

  private View view() {
    return new View(camera, width, height);
  }

  private double distance() {
    return camera.position().minus(camera.lookAt()).length();
  }

  /** Returns the place of the unit ball, as seen by the camera, that is at one of the picture. */
  private Vector3d onBall(double column, double row) {
    double side = Math.min(width, height);
    double x = (2 * column - width) / side;
    double y = (height - 2 * row) / side;
    double square = x * x + y * y;
    return square > 1
        ? new Vector3d(x, y, 0).normalized()
        : new Vector3d(x, y, Math.sqrt(1 - square));
  }

  private static Vector3d inWorld(View view, Vector3d v) {
    Vector3d across = view.right().times(v.x()).plus(view.up().times(v.y()));
    return across.minus(view.forward().times(v.z()));
  }

  private Camera turned(View view, Quaternion by) {
    Transform turn = Transform.rotate(by);
    Vector3d back = turn.direction(camera.position().minus(camera.lookAt()));
    return placed(camera.lookAt().plus(back), camera.lookAt(), turn.direction(view.up()));
  }

  private Camera placed(Vector3d position, Vector3d lookAt, Vector3d up) {
    return with(position, lookAt, up, camera.projection());
  }

  /** What is sharp stays as far from the target, as a part of the distance. */
  private Camera with(Vector3d position, Vector3d lookAt, Vector3d up, Projection projection) {
    double nearer = position.minus(lookAt).length() / distance();
    Optional<Lens> lens = camera.lens().map(l -> new Lens(l.radius(), nearer * l.focus()));
    return new Camera(
        position, lookAt, up.normalized(), projection, camera.near(), camera.far(), lens);
  }
}
