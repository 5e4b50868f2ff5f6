package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.formdev.flatlaf.FlatLaf;
import glint.desktop.window.Desk;
import glint.desktop.window.SceneSource;
import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a window keeps on disk from one time to the next. */
@Tag("window")
class WindowMemoryTest {

  private static final SceneSource SOURCE =
      file -> WindowCommand.read(file, new PrintWriter(Writer.nullWriter()));

  @TempDir private Path dir;

  @Test
  void theWindowComesBackWhereItWasInItsLook() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    Desk desk = OnScreen.desk(SOURCE, dir.resolve("home"), Map.of());
    Rectangle bounds = new Rectangle(40, 30, 900, 600);
    int list = 180;
    int side = 260;
    try (OnScreen screen = new OnScreen(List.of(file), desk)) {
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_D);
      EventThread.on(
          () -> {
            screen.frame().setBounds(bounds);
            return null;
          });
      screen.await("its place", () -> screen.frame().getBounds().equals(bounds));
      EventThread.on(
          () -> {
            JSplitPane inner = split(screen, "side");
            split(screen, "scenes").setDividerLocation(list);
            screen.frame().validate();
            inner.setDividerLocation(inner.getWidth() - inner.getDividerSize() - side);
            return null;
          });
      screen.await("its parts", () -> widths(screen).equals(List.of(list, side)));
    }
    Properties kept = new Properties();
    kept.load(Files.newBufferedReader(desk.state()));
    assertEquals("40, 30", kept.getProperty("x") + ", " + kept.getProperty("y"));
    assertEquals(file.toString(), kept.getProperty("recent.0"));
    try (OnScreen screen = new OnScreen(List.of(file), desk)) {
      screen.awaitStatus("done");
      assertEquals(bounds.getSize(), screen.frame().getSize()); // without a window manager
      assertEquals(List.of(list, side), widths(screen));
      assertTrue(((FlatLaf) UIManager.getLookAndFeel()).isDark());
    }
  }

  @Test
  void smallPicturesAreMadeAfterTheRenderAndKept() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two", "three");
    Desk desk = OnScreen.desk(SOURCE, dir.resolve("home"), Map.of());
    try (OnScreen screen = new OnScreen(List.of(file), desk)) {
      screen.awaitStatus("done");
      screen.await("small pictures", () -> kept(desk).size() == 3);
    }
    List<Path> before = kept(desk);
    Map<String, String> digests = Run.digests(desk.cache());
    try (OnScreen screen = new OnScreen(List.of(file), desk)) {
      screen.awaitStatus("done");
    }
    assertEquals(before, kept(desk));
    assertEquals(digests, Run.digests(desk.cache()));
  }

  /** Returns what parts the window beside a part of it. */
  private static JSplitPane split(OnScreen screen, String part) {
    Component at = screen.part(part, JComponent.class);
    return (JSplitPane) SwingUtilities.getAncestorOfClass(JSplitPane.class, at);
  }

  private static List<Integer> widths(OnScreen screen) {
    int list = split(screen, "scenes").getLeftComponent().getWidth();
    return List.of(list, screen.part("side", JComponent.class).getWidth());
  }

  private static List<Path> kept(Desk desk) {
    try {
      return Run.list(desk.cache()).stream()
          .filter(name -> name.endsWith(".png"))
          .map(Path::of)
          .toList();
    } catch (java.io.IOException e) {
      throw new IllegalStateException(e);
    }
  }
}
