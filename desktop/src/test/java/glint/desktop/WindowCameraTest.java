package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.desktop.window.Picked;
import glint.desktop.window.SceneSource;
import glint.io.CameraText;
import glint.render.RenderSettings;
import glint.render.Replay;
import glint.scene.Camera;
import glint.scene.Handheld;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.awt.Component;
import java.awt.Point;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.swing.JComponent;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Moves the camera in a real window, where every pixel of the image is one of the screen. */
@Tag("window")
class WindowCameraTest {

  private static final int LEFT = InputEvent.BUTTON1_DOWN_MASK;
  private static final int MIDDLE = InputEvent.BUTTON2_DOWN_MASK;

  @TempDir private Path dir;

  private Scene scene;
  private OnScreen screen;
  private Component view;

  private interface Work {
    void run() throws Exception;
  }

  private void open(Work work) throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    scene = WindowTest.read(file).scenes().get(0).scene();
    try (OnScreen opened = new OnScreen(List.of(file), WindowTest::read)) {
      screen = opened;
      view = screen.part("picture", JComponent.class);
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_1);
      work.run();
    }
  }

  /** Returns where in the view a place in the image is. */
  private Point at(int column, int row) {
    int left = (int) Math.rint((view.getWidth() - scene.width()) / 2.0);
    int top = (int) Math.rint((view.getHeight() - scene.height()) / 2.0);
    return new Point(left + column, top + row);
  }

  private Handheld held(Camera camera) {
    return new Handheld(camera, scene.width(), scene.height());
  }

  private String cameraText() {
    screen.hands().key(KeyEvent.VK_Y);
    try {
      return Toolkit.getDefaultToolkit()
          .getSystemClipboard()
          .getData(DataFlavor.stringFlavor)
          .toString();
    } catch (IOException | UnsupportedFlavorException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Checks that the window has a camera, and comes to show the very image that it sees. */
  private void assertSees(Camera camera) throws Exception {
    screen.hands().key(KeyEvent.VK_Y);
    Object text = Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
    assertEquals(CameraText.of(camera), text);
    Scene picture = scene.seenBy(camera, scene.width(), scene.height());
    int[] expected = WindowTest.batch(picture);
    screen.awaitShown(
        "the image",
        () ->
            screen.text("status").startsWith("done")
                && Arrays.equals(expected, screen.middle(view, scene.width(), scene.height())));
  }

  @Test
  void draggingGoesAboutTheTargetAndAcross() throws Exception {
    open(
        () -> {
          screen.hands().drag(view, at(20, 15), at(26, 19), LEFT);
          Camera camera = held(scene.camera()).orbited(20, 15, 26, 19);
          assertSees(camera);
          screen
              .hands()
              .with(KeyEvent.VK_SHIFT, () -> screen.hands().drag(view, at(3, 4), at(8, 2), LEFT));
          camera = held(camera).panned(5, -2);
          assertSees(camera);
          screen.hands().drag(view, at(3, 4), at(13, 2), MIDDLE);
          camera = held(camera).panned(10, -2);
          assertSees(camera);
          screen.hands().key(KeyEvent.VK_R);
          assertSees(scene.camera());
        });
  }

  @Test
  void theWheelGoesNearerAndRolls() throws Exception {
    open(
        () -> {
          screen.hands().moveTo(view, 100, 100);
          screen.hands().wheel(2);
          Camera camera = held(held(scene.camera()).dollied(1.1)).dollied(1.1);
          assertSees(camera);
          screen.hands().with(KeyEvent.VK_SHIFT, () -> screen.hands().wheel(-1));
          assertSees(held(camera).rolled(-5));
        });
  }

  @Test
  void withTheControlKeyTheMouseMovesThePictureAlone() throws Exception {
    open(
        () -> {
          int[] before = screen.middle(view, scene.width(), scene.height());
          Point there = at(80, 60);
          screen
              .hands()
              .with(KeyEvent.VK_CONTROL, () -> screen.hands().drag(view, at(20, 15), there, LEFT));
          screen.hands().moveTo(view, there.x, there.y);
          assertEquals("20, 15:", screen.text("pixel").substring(0, 7));
          screen.hands().key(KeyEvent.VK_1);
          assertEquals(
              Arrays.hashCode(before),
              Arrays.hashCode(screen.middle(view, scene.width(), scene.height())));
          assertSees(scene.camera());
        });
  }

  @Test
  @Timeout(60)
  void aDoubleClickSetsTheTargetAndKeysGoAboutIt() throws Exception {
    open(
        () -> {
          while (cameraText().equals(CameraText.of(scene.camera()))) {
            screen.hands().doubleClick(view, at(28, 22).x, at(28, 22).y);
            Thread.sleep(1000); // on a busy machine the clicks may be too far apart
          }
          RenderSettings one = RenderSettings.of(scene).sampled(1, 0);
          Replay.Sample sample = new Replay(Prepared.of(scene), one, 28, 22).sample(0);
          Camera camera = held(scene.camera()).aimed(sample.tree().met().get().point());
          assertSees(camera);
          screen.hands().key(KeyEvent.VK_I);
          double way = 15 * StrictMath.sin(StrictMath.toRadians(5));
          assertSees(held(camera).orbited(20, 15, 20, 15 + way));
        });
  }

  @Test
  void escapeEndsTheWayOfTheCameraWithoutARender() throws Exception {
    SceneSource.Found gallery = WindowTest.read(WindowTest.GALLERY);
    List<Picked> slow =
        gallery.scenes().stream().filter(p -> p.scene().name().equals("glass-still-life")).toList();
    SceneSource.Found found = new SceneSource.Found(slow, List.of(), gallery.parts());
    try (OnScreen opened = new OnScreen(List.of(WindowTest.GALLERY), file -> found)) {
      opened.awaitStatus("rendering");
      Robot robot = opened.hands().robot();
      for (int key : new int[] {KeyEvent.VK_PERIOD, KeyEvent.VK_ESCAPE}) {
        robot.keyPress(key); // the camera rests soon
        robot.keyRelease(key);
      }
      opened.awaitStatus("stopped");
      Thread.sleep(500);
      assertEquals("stopped", opened.text("status").substring(0, 7));
      opened.hands().key(KeyEvent.VK_PERIOD);
      opened.awaitStatus("rendering");
    }
  }

  @Test
  void aMovedCameraStaysWhenItsFileIsSavedUnlessThatMovesItsOwn() throws Exception {
    open(
        () -> {
          Path file = dir.resolve("a.yaml");
          screen.hands().key(KeyEvent.VK_PERIOD);
          Camera camera = held(scene.camera()).rolled(5);
          assertSees(camera);
          Files.writeString(file, Files.readString(file).replace("radius: 1", "radius: 0.75"));
          scene = WindowTest.read(file).scenes().get(0).scene();
          assertSees(camera);
          Files.writeString(file, Files.readString(file).replace("fov: 40", "fov: 30"));
          scene = WindowTest.read(file).scenes().get(0).scene();
          String own = CameraText.of(scene.camera());
          screen.awaitShown("its own camera", () -> cameraText().equals(own));
          assertSees(scene.camera());
        });
  }
}
