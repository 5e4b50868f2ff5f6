package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.desktop.window.Picked;
import glint.desktop.window.SceneSource;
import glint.image.Image;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Drives a real window. */
@Tag("window")
class WindowTest {

  static final Path GALLERY = Path.of("..", "scenes", "gallery.yaml");

  @TempDir private Path dir;

  @Test
  void everySceneOfTheGalleryArrivesAsTheBatchRendersIt() throws Exception {
    SceneSource.Found gallery = small(WindowCommand.read(GALLERY, err()));
    assertTrue(gallery.scenes().size() > 10);
    try (OnScreen screen = new OnScreen(List.of(GALLERY), file -> gallery)) {
      JList<?> list = screen.part("scenes", JList.class);
      Component view = screen.part("picture", JComponent.class);
      screen.await("the list", () -> list.getModel().getSize() == gallery.scenes().size());
      for (Picked picked : gallery.scenes()) {
        String name = picked.scene().name();
        screen.await(name, () -> screen.frame().getTitle().startsWith(name));
        screen.awaitStatus("done");
        screen.hands().key(KeyEvent.VK_1);
        Image batch = image(picked.scene());
        int[] expected = batch.toArgb(picked.scene().transfer());
        assertArrayEquals(expected, screen.middle(view, batch.width(), batch.height()), name);
        screen.hands().key(KeyEvent.VK_DOWN);
      }
    }
  }

  @Test
  void aRenderIsPausedGoesOnAndIsStopped() throws Exception {
    SceneSource.Found gallery = WindowCommand.read(GALLERY, err());
    try (OnScreen screen = new OnScreen(List.of(GALLERY), file -> gallery)) {
      JButton pause = screen.part("Pause", JButton.class);
      screen.awaitStatus("rendering");
      screen.hands().click(pause);
      screen.awaitStatus("paused");
      assertEquals("Continue", pause.getText());
      String status = screen.text("status");
      Thread.sleep(300);
      assertEquals(status, screen.text("status"));
      screen.hands().key(KeyEvent.VK_SPACE);
      screen.awaitStatus("rendering");
      screen.hands().key(KeyEvent.VK_ESCAPE);
      screen.awaitStatus("stopped");
      assertFalse(pause.isEnabled());
    }
  }

  @Test
  void everyButtonIsSeenInANarrowWindow() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    try (OnScreen screen = new OnScreen(List.of(file), WindowTest::read)) {
      screen.awaitStatus("done");
      Container bar = screen.part("Reset camera", JButton.class).getParent();
      for (int width : new int[] {1200, 800, 500}) {
        EventThread.on(
            () -> {
              screen.frame().setSize(width, 500);
              screen.frame().validate();
              return null;
            });
        screen.await("its width", () -> bar.getWidth() == screen.frame().getWidth());
        Rectangle room = new Rectangle(bar.getSize());
        for (Component part : bar.getComponents()) {
          assertTrue(room.contains(part.getBounds()), width + ": " + part);
          boolean whole = part.getWidth() >= part.getPreferredSize().width;
          assertTrue(whole || part instanceof JLabel, width + ": " + part);
        }
        assertEquals(width == 500 ? 2 : 1, bar.getHeight() / bar.getComponent(0).getHeight());
      }
    }
  }

  @Test
  void closingEndsARender() throws Exception {
    SceneSource.Found gallery = WindowCommand.read(GALLERY, err());
    try (OnScreen screen = new OnScreen(List.of(GALLERY), file -> gallery)) {
      screen.awaitStatus("rendering");
    }
  }

  @Test
  void thePixelUnderThePointerIsTold() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    SceneSource source = each -> WindowCommand.read(each, err());
    try (OnScreen screen = new OnScreen(List.of(file), source)) {
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_1);
      Component view = screen.part("picture", JComponent.class);
      Scene scene = source.read(file).scenes().get(0).scene();
      double[] rgb = image(scene).rgb();
      int left = (int) Math.rint((view.getWidth() - scene.width()) / 2.0);
      int top = (int) Math.rint((view.getHeight() - scene.height()) / 2.0);
      screen.hands().moveTo(view, left + 20, top + 15);
      int i = 3 * (15 * scene.width() + 20);
      String value =
          String.format(Locale.ROOT, "20, 15: %.5f %.5f %.5f", rgb[i], rgb[i + 1], rgb[i + 2]);
      assertEquals(value, screen.text("pixel"));
      screen.hands().with(KeyEvent.VK_CONTROL, () -> screen.hands().wheel(-3));
      assertEquals(value, screen.text("pixel"));
      screen.hands().moveTo(view, 2, 2);
      assertEquals(" ", screen.text("pixel"));
    }
  }

  @Test
  void whatIsWrongWithAFileIsShownBesideItsGoodScenes() throws Exception {
    Path good = Scenes.write(dir.resolve("good.yaml"), "one");
    Path bad = Scenes.write(dir.resolve("bad.yaml"), "two");
    Files.writeString(bad, Files.readString(bad).replace("radius: 1", "radius: 0"));
    SceneSource source = each -> WindowCommand.read(each, err());
    try (OnScreen screen = new OnScreen(List.of(bad, good), source)) {
      JList<?> problems = screen.part("problems", JList.class);
      screen.await("the problem", () -> problems.getModel().getSize() == 1);
      String line = problems.getModel().getElementAt(0).toString();
      assertTrue(line.startsWith(bad + ":") && line.contains("radius"), line);
      screen.await("its line", () -> problems.isShowing() && problems.getHeight() > 0);
      assertTrue(problems.getVisibleRect().contains(problems.getCellBounds(0, 0)));
      assertEquals(1, screen.part("scenes", JList.class).getModel().getSize());
      screen.awaitStatus("done");
    }
  }

  @Test
  void filesThatAreDroppedJoinTheListAndReplaceThemselves() throws Exception {
    Path first = Scenes.write(dir.resolve("first.yaml"), "one", "two");
    Path second = Scenes.write(dir.resolve("second.yaml"), "three", "four");
    SceneSource source = each -> WindowCommand.read(each, err());
    try (OnScreen screen = new OnScreen(List.of(first), source)) {
      JList<?> list = screen.part("scenes", JList.class);
      screen.await("the first", () -> list.getModel().getSize() == 2);
      assertEquals("two", screen.line(list, 1));
      assertTrue(screen.hands().drop(screen.frame(), List.of(second)));
      screen.await("the second", () -> list.getModel().getSize() == 4);
      assertTrue(screen.frame().getTitle().startsWith("three"), screen.frame().getTitle());
      Scenes.write(first, "five");
      assertTrue(screen.hands().drop(screen.frame(), List.of(first)));
      screen.await("the change", () -> list.getModel().getSize() == 3);
      assertTrue(screen.frame().getTitle().startsWith("five"), screen.frame().getTitle());
      screen.awaitStatus("done");
    }
  }

  /** Returns the codes of a scene's image as the batch renders it. */
  static int[] batch(Scene scene) {
    return image(scene).toArgb(scene.transfer());
  }

  static Image image(Scene scene) {
    Renderer renderer = new Renderer(Prepared.of(scene), RenderSettings.of(scene));
    return renderer.render(Progress.NONE).image();
  }

  private static SceneSource.Found small(SceneSource.Found found) {
    List<Picked> scenes =
        found.scenes().stream()
            .map(
                p -> new Picked(p.file(), p.digest(), p.scene().seenBy(p.scene().camera(), 48, 32)))
            .toList();
    return new SceneSource.Found(scenes, found.problems(), found.parts());
  }

  /** Reads a file as the command does. */
  static SceneSource.Found read(Path file) {
    return WindowCommand.read(file, err());
  }

  private static PrintWriter err() {
    return new PrintWriter(Writer.nullWriter());
  }
}
