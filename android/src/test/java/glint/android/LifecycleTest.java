package glint.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import android.content.ComponentCallbacks2;
import android.os.Bundle;
import android.view.KeyEvent;
import android.widget.ProgressBar;
import android.widget.TextView;
import glint.android.Status.State;
import glint.scene.Camera;
import glint.scene.Handheld;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;
import org.robolectric.shadows.ShadowToast;

/** What becomes of a render while the device is turned, the app is left, or memory is short. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class LifecycleTest {

  /** Takes long enough to be met in the middle. */
  private static final String SLOW = "glass-still-life";

  private static final Settings AS_DESKTOP = new Settings(4, 2, Settings.Size.W160);
  private static final Settings ENDLESS = new Settings(0.25f, 2, Settings.Size.W1280);

  private static ActivityController<RenderActivity> open(String scene, Settings settings) {
    return Screens.open(SceneReader.GALLERY, scene, settings);
  }

  private static State state(RenderActivity screen) {
    return screen.session().status().state();
  }

  private static void awaitMiddle(RenderActivity screen) {
    Waiting.until("there is a picture", () -> screen.session().bitmap() != null);
    assertEquals(State.RENDERING, state(screen));
  }

  private static void awaitDesktopImage(RenderActivity screen) {
    Waiting.until("it is over", () -> state(screen).isOver());
    assertEquals(State.DONE, state(screen));
    PictureView picture = screen.findViewById(R.id.picture);
    Desktop.assertSame(SLOW, picture.bitmap());
  }

  private static String said(RenderActivity screen, int view) {
    TextView text = screen.findViewById(view);
    return text.getText().toString();
  }

  private static long renderThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().equals("glint-render"))
        .count();
  }

  /** Waits until pieces of work that have begun are done; returns the rays traced then. */
  private static long quietRays(RenderActivity screen) throws InterruptedException {
    long before = -1;
    long now = screen.session().status().rays();
    while (now != before) {
      Thread.sleep(500);
      before = now;
      now = screen.session().status().rays();
    }
    return now;
  }

  @Test
  public void turningKeepsTheRender() {
    try (ActivityController<RenderActivity> controller = open(SLOW, AS_DESKTOP)) {
      RenderActivity before = controller.get();
      awaitMiddle(before);
      Session session = before.session();
      RuntimeEnvironment.setQualifiers("+land");
      controller.configurationChange();
      RenderActivity after = controller.get();
      assertTrue(before != after && before.isDestroyed());
      assertSame(session, after.session());
      assertEquals(State.RENDERING, state(after));
      PictureView picture = after.findViewById(R.id.picture);
      assertNotNull(picture.bitmap());
      awaitDesktopImage(after);
    }
  }

  @Test
  public void leavingPausesAndReturningGoesOn() throws InterruptedException {
    try (ActivityController<RenderActivity> controller = open(SLOW, AS_DESKTOP)) {
      RenderActivity screen = controller.get();
      awaitMiddle(screen);
      assertTrue(screen.findViewById(R.id.picture).getKeepScreenOn());
      controller.pause().stop();
      assertEquals(State.PAUSED, state(screen));
      long rays = quietRays(screen);
      Thread.sleep(300);
      assertEquals(rays, screen.session().status().rays());
      assertEquals(State.PAUSED, state(screen));
      controller.restart().start().resume();
      assertEquals(State.RENDERING, state(screen));
      awaitDesktopImage(screen);
      PictureView picture = screen.findViewById(R.id.picture);
      Waiting.until("the screen may go off", () -> !picture.getKeepScreenOn());
      assertEquals("Finished", said(screen, R.id.state));
    }
  }

  @Test
  public void howMuchIsLeftIsTold() {
    try (ActivityController<RenderActivity> controller = open(SLOW, ENDLESS)) {
      RenderActivity screen = controller.get();
      ProgressBar bar = screen.findViewById(R.id.progress);
      Waiting.until(
          "it says so",
          () -> said(screen, R.id.figures).matches(".* M rays/s.* · about [0-9]+ s left"));
      assertFalse(bar.isIndeterminate());
      assertTrue(bar.getProgress() < bar.getMax());
      Waiting.until("the bar has moved", () -> bar.getProgress() > 0);
    }
  }

  @Test
  public void whatAPersonPausesStaysPaused() {
    try (ActivityController<RenderActivity> controller = open(SLOW, ENDLESS)) {
      RenderActivity screen = controller.get();
      awaitMiddle(screen);
      screen.session().pause(true);
      controller.pause().stop().restart().start().resume();
      Waiting.until("it says so", () -> said(screen, R.id.state).equals("Paused"));
      assertFalse(screen.findViewById(R.id.picture).getKeepScreenOn());
      screen.session().pause(false);
      Waiting.until("it goes on", () -> said(screen, R.id.state).equals("Rendering…"));
    }
  }

  @Test
  public void goingBackEndsTheRender() {
    ActivityController<RenderActivity> controller = open(SLOW, ENDLESS);
    RenderActivity screen = controller.get();
    awaitMiddle(screen);
    assertTrue(renderThreads() > 0);
    screen.dispatchKeyEvent(new KeyEvent(KeyEvent.ACTION_DOWN, KeyEvent.KEYCODE_BACK));
    screen.dispatchKeyEvent(new KeyEvent(KeyEvent.ACTION_UP, KeyEvent.KEYCODE_BACK));
    assertTrue(screen.isFinishing());
    controller.pause().stop().destroy();
    assertEquals(State.STOPPED, state(screen));
    Waiting.until("no thread is left", () -> renderThreads() == 0);
    controller.close();
  }

  @Test
  public void anAppThatWasEndedShowsTheSameSceneByTheSameCamera() {
    Bundle kept = new Bundle();
    Camera camera;
    try (ActivityController<RenderActivity> controller = open("checkmate", AS_DESKTOP)) {
      Session session = controller.get().session();
      camera = new Handheld(session.camera(), 160, 120).orbited(80, 60, 100, 50);
      session.look(camera, false);
      controller.pause().stop().saveInstanceState(kept);
    }
    GlintApplication.library(RuntimeEnvironment.getApplication()).forget();
    try (ActivityController<RenderActivity> controller =
        Robolectric.buildActivity(
            RenderActivity.class,
            RenderActivity.intent(
                RuntimeEnvironment.getApplication(), SceneReader.GALLERY, "checkmate"))) {
      RenderActivity screen = controller.setup(kept).get();
      Waiting.until("the scene is read", () -> screen.session() != null);
      assertEquals("checkmate", screen.session().scene().name());
      assertEquals(camera, screen.session().camera());
    }
  }

  @Test
  public void shortMemoryMakesThePictureSmaller() {
    try (ActivityController<RenderActivity> controller = open(SLOW, ENDLESS)) {
      RenderActivity screen = controller.get();
      awaitMiddle(screen);
      screen.onTrimMemory(ComponentCallbacks2.TRIM_MEMORY_RUNNING_CRITICAL);
      Waiting.until("it says so", () -> said(screen, R.id.note).contains("640 × 360"));
      Waiting.until(
          "there is a smaller picture", () -> screen.session().bitmap().getWidth() == 640);
      assertEquals(State.RENDERING, state(screen));
      for (int i = 0; i < 10; i++) {
        screen.onTrimMemory(ComponentCallbacks2.TRIM_MEMORY_RUNNING_CRITICAL);
      }
      assertEquals(90, screen.session().height());
    }
  }

  @Test
  public void aSceneThatIsGoneIsSaidToBe() {
    try (ActivityController<RenderActivity> controller = open("no-such-scene", AS_DESKTOP)) {
      assertTrue(controller.get().isFinishing());
      assertEquals("the scene is no longer in its file", ShadowToast.getTextOfLatestToast());
    }
  }
}
