package glint.android;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import android.graphics.PointF;
import android.view.MotionEvent;
import android.view.MotionEvent.PointerCoords;
import android.view.MotionEvent.PointerProperties;
import glint.image.Image;
import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Camera;
import glint.scene.Handheld;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;
import org.robolectric.fakes.RoboMenuItem;

/** Fingers on the picture move the camera. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class TouchTest {

  private static final int WIDTH = 160;
  private static final int HEIGHT = 120;

  private ActivityController<RenderActivity> controller;
  private Session session;
  private PictureView picture;

  @Before
  public void open() {
    Settings small = new Settings(4, 2, Settings.Size.W160);
    controller = Screens.open(SceneReader.GALLERY, "checkmate", small);
    session = controller.get().session();
    picture = controller.get().findViewById(R.id.picture);
    awaitPicture();
  }

  @After
  public void close() {
    controller.close();
  }

  private void awaitPicture() {
    Waiting.until(
        "it is done", () -> !session.isMoving() && session.status().state() == Status.State.DONE);
  }

  /** Puts fingers at pairs of coordinates. */
  private void fingers(int action, float... at) {
    PointerProperties[] which = new PointerProperties[at.length / 2];
    PointerCoords[] where = new PointerCoords[at.length / 2];
    for (int i = 0; i < which.length; i++) {
      which[i] = new PointerProperties();
      which[i].id = i;
      where[i] = new PointerCoords();
      where[i].x = at[2 * i];
      where[i].y = at[2 * i + 1];
    }
    MotionEvent event =
        MotionEvent.obtain(0, 0, action, which.length, which, where, 0, 0, 1, 1, 0, 0, 0, 0);
    picture.dispatchTouchEvent(event);
    event.recycle();
  }

  private static int secondFinger(int action) {
    return action | 1 << MotionEvent.ACTION_POINTER_INDEX_SHIFT;
  }

  private Handheld held() {
    return new Handheld(session.scene().camera(), WIDTH, HEIGHT);
  }

  private double distance() {
    return session.camera().position().minus(session.camera().lookAt()).length();
  }

  @Test
  public void oneFingerOrbits() {
    fingers(MotionEvent.ACTION_DOWN, 100, 150);
    fingers(MotionEvent.ACTION_MOVE, 170, 190);
    assertTrue(session.isMoving());
    Waiting.until("there is a coarse picture", () -> session.bitmap().getWidth() < WIDTH);
    fingers(MotionEvent.ACTION_UP, 170, 190);
    assertFalse(session.isMoving());
    PointF a = picture.inPicture(100, 150, WIDTH, HEIGHT);
    PointF b = picture.inPicture(170, 190, WIDTH, HEIGHT);
    Camera moved = held().orbited(a.x, a.y, b.x, b.y);
    assertEquals(moved, session.camera());
    awaitPicture();
    assertArrayEquals(rendered(moved), Desktop.pixels(picture.bitmap()));
  }

  private int[] rendered(Camera camera) {
    Scene scene = session.scene().seenBy(camera, WIDTH, HEIGHT);
    RenderSettings settings =
        new RenderSettings(
            WIDTH, HEIGHT, new Goal.Error(4), 0, OptionalInt.empty(), 1, 32, Set.of());
    Image image = new Renderer(Prepared.of(scene), settings).render(Progress.NONE).image();
    return image.toArgb(scene.transfer());
  }

  @Test
  public void aDragThatReturnsLeadsBack() {
    Camera before = session.camera();
    fingers(MotionEvent.ACTION_DOWN, 100, 150);
    fingers(MotionEvent.ACTION_MOVE, 20, 300);
    fingers(MotionEvent.ACTION_MOVE, 100, 150);
    fingers(MotionEvent.ACTION_UP, 100, 150);
    assertEquals(0, before.position().minus(session.camera().position()).length(), 1e-12);
  }

  @Test
  public void twoFingersComeNearerAndPan() {
    double before = distance();
    fingers(MotionEvent.ACTION_DOWN, 100, 200);
    fingers(secondFinger(MotionEvent.ACTION_POINTER_DOWN), 100, 200, 200, 200);
    fingers(MotionEvent.ACTION_MOVE, 50, 200, 250, 200);
    assertEquals(before / 2, distance(), 1e-5 * before);
    fingers(MotionEvent.ACTION_MOVE, 130, 200, 230, 200);
    assertEquals(before, distance(), 1e-5 * before);
    float columns = 30 * WIDTH / (float) picture.getWidth();
    Camera panned = held().panned(columns, 0);
    assertEquals(0, panned.lookAt().minus(session.camera().lookAt()).length(), 1e-5 * before);
    fingers(secondFinger(MotionEvent.ACTION_POINTER_UP), 130, 200, 230, 200);
    fingers(MotionEvent.ACTION_UP, 130, 200);
    assertEquals(0, panned.lookAt().minus(session.camera().lookAt()).length(), 1e-5 * before);
  }

  @Test
  public void twoFingersRollAsTheyTurn() {
    fingers(MotionEvent.ACTION_DOWN, 100, 200);
    fingers(secondFinger(MotionEvent.ACTION_POINTER_DOWN), 100, 200, 200, 200);
    fingers(MotionEvent.ACTION_MOVE, 150, 150, 150, 250);
    Camera rolled = held().rolled(90);
    assertEquals(0, rolled.up().minus(session.camera().up()).length(), 1e-5);
    fingers(MotionEvent.ACTION_CANCEL, 150, 150, 150, 250);
    assertFalse(session.isMoving());
  }

  @Test
  public void theMenuLeadsBackToTheScenesOwnCamera() {
    fingers(MotionEvent.ACTION_DOWN, 100, 150);
    fingers(MotionEvent.ACTION_MOVE, 170, 190);
    fingers(MotionEvent.ACTION_UP, 170, 190);
    controller.get().onOptionsItemSelected(new RoboMenuItem(R.id.reset));
    assertEquals(session.scene().camera(), session.camera());
    awaitPicture();
    Desktop.assertSame("checkmate", picture.bitmap());
  }

  @Test
  public void aTapMovesNothing() {
    fingers(MotionEvent.ACTION_DOWN, 100, 150);
    fingers(MotionEvent.ACTION_MOVE, 101, 151);
    fingers(MotionEvent.ACTION_UP, 101, 151);
    assertEquals(session.scene().camera(), session.camera());
    assertEquals(Status.State.DONE, session.status().state());
  }
}
