package glint.android;

import android.graphics.PointF;
import android.view.MotionEvent;
import android.view.View;
import android.view.ViewConfiguration;
import glint.math.BadValueException;
import glint.scene.Camera;
import glint.scene.Handheld;
import java.util.function.Supplier;

/**
 * Moves a scene's camera by touch: one finger goes about the target, two pinch to come nearer, turn
 * to roll and drag to pan. All of a gesture is told from its beginning.
 */
final class Touch implements View.OnTouchListener {

  private final PictureView picture;
  private final Supplier<Session> session;

  private Handheld held;
  private boolean moved;

  /** Where the fingers were at the beginning; the second is null where there is but one. */
  private PointF first;

  private PointF second;

  /** Listens to touches of a picture. */
  Touch(PictureView picture, Supplier<Session> session) {
    this.picture = picture;
    this.session = session;
  }

  @Override
  public boolean onTouch(View view, MotionEvent event) {
    Session now = session.get();
    if (now == null) {
      return false;
    }
    switch (event.getActionMasked()) {
      case MotionEvent.ACTION_DOWN, MotionEvent.ACTION_POINTER_DOWN -> begin(now, event, -1);
      case MotionEvent.ACTION_POINTER_UP -> begin(now, event, event.getActionIndex());
      case MotionEvent.ACTION_MOVE -> move(now, event);
      case MotionEvent.ACTION_UP -> {
        end(now);
        view.performClick();
      }
      default -> end(now);
    }
    return true;
  }

  /** Begins with the fingers that are there, but for one that is just lifted. */
  private void begin(Session now, MotionEvent event, int lifted) {
    held = new Handheld(now.camera(), now.width(), now.height());
    int one = lifted == 0 ? 1 : 0;
    int other = lifted == one + 1 ? one + 2 : one + 1;
    first = place(event, one);
    second = other < event.getPointerCount() ? place(event, other) : null;
  }

  private PointF place(MotionEvent event, int finger) {
    return picture.inPicture(event.getX(finger), event.getY(finger), held.width(), held.height());
  }

  private void move(Session now, MotionEvent event) {
    PointF a = place(event, 0);
    PointF b = second == null ? null : place(event, 1);
    moved |= isFar(a, first) || (b != null && isFar(b, second));
    if (moved) {
      try {
        now.look(b == null ? held.orbited(first.x, first.y, a.x, a.y) : pinched(a, b), true);
      } catch (BadValueException e) {
        // so far away that coordinates end: the camera stays where it is
      }
    }
  }

  private Camera pinched(PointF a, PointF b) {
    float dx = (a.x + b.x - first.x - second.x) / 2;
    float dy = (a.y + b.y - first.y - second.y) / 2;
    double nearer = distance(first, second) / Math.max(1, distance(a, b));
    double turn = StrictMath.toDegrees(angle(a, b) - angle(first, second));
    return with(with(with(held.panned(dx, dy)).rolled(turn)).dollied(nearer)).camera();
  }

  private Handheld with(Camera camera) {
    return new Handheld(camera, held.width(), held.height());
  }

  private static double angle(PointF from, PointF to) {
    return StrictMath.atan2(to.y - from.y, to.x - from.x);
  }

  private static double distance(PointF from, PointF to) {
    return StrictMath.hypot(to.x - from.x, to.y - from.y);
  }

  /** Returns whether a finger has moved by more than it trembles. */
  private boolean isFar(PointF from, PointF to) {
    int slop = ViewConfiguration.get(picture.getContext()).getScaledTouchSlop();
    PointF origin = picture.inPicture(0, 0, held.width(), held.height());
    PointF tremble = picture.inPicture(slop, 0, held.width(), held.height());
    return distance(from, to) > distance(origin, tremble);
  }

  private void end(Session now) {
    if (moved) {
      moved = false;
      now.look(now.camera(), false);
    }
  }
}
