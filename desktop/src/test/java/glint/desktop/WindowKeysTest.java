package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.desktop.window.SceneSource;
import java.awt.Component;
import java.awt.Container;
import java.awt.FocusTraversalPolicy;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javax.accessibility.AccessibleContext;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JScrollBar;
import javax.swing.JSlider;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.UIManager;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checks that everything can be done by keys and that everything has a name. */
@Tag("window")
class WindowKeysTest {

  private static final SceneSource SOURCE =
      file -> WindowCommand.read(file, new PrintWriter(Writer.nullWriter()));

  /** What the user works with, also where it is not seen at first. */
  private static final List<Class<?>> KINDS =
      List.of(
          AbstractButton.class,
          JTextComponent.class,
          JList.class,
          JSlider.class,
          JTree.class,
          JTable.class,
          JComboBox.class);

  @TempDir private Path dir;

  @Test
  void whatTakesTheFocusHasANameAndEveryCommandAKeyOfItsOwn() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      Set<Component> reached = EventThread.on(() -> reached(screen.frame()));
      assertTrue(reached.contains(screen.part("scenes", JComponent.class)));
      List<String> nameless = new ArrayList<>();
      EventThread.on(
          () -> {
            walk(screen.frame().getRootPane(), reached, nameless);
            return null;
          });
      assertEquals(List.of(), nameless);
      Set<Object> keys = new HashSet<>();
      JMenuBar menus = screen.frame().getJMenuBar();
      for (int i = 0; i < menus.getMenuCount(); i++) {
        JMenu menu = menus.getMenu(i);
        for (Component each : menu.getMenuComponents()) {
          if (each instanceof JMenuItem item && !(each instanceof JMenu)) {
            assertTrue(item.getAccelerator() != null, item.getText());
            assertTrue(keys.add(item.getAccelerator()), item.getText());
          }
        }
      }
    }
  }

  @Test
  void aSheetShowsAllKeys() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_F1);
      screen.await("the sheet", () -> sheets() == 1);
      screen.await("its focus", () -> !screen.frame().isFocused());
      screen.hands().key(KeyEvent.VK_ESCAPE);
      screen.await("no sheet", () -> sheets() == 0);
    }
  }

  @Test
  void everyPartFollowsTheLook() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_D);
      screen.await("the dark", () -> UIManager.getLookAndFeel().getName().contains("Dark"));
      screen.hands().key(KeyEvent.VK_E);
      screen.await("a legend", screen.part("legend", JComponent.class)::isShowing);
      assertEquals(List.of(), EventThread.on(() -> light(screen.frame().getRootPane())));
    }
  }

  /** Returns the parts with a light background. */
  private static List<String> light(Component at) {
    List<String> found = new ArrayList<>();
    if (at instanceof JComponent && at.isOpaque() && at.getBackground().getGreen() > 127) {
      found.add(at.toString());
    }
    if (at instanceof Container inner) {
      for (Component each : inner.getComponents()) {
        found.addAll(light(each));
      }
    }
    return found;
  }

  private static long sheets() {
    return Arrays.stream(Window.getWindows())
        .filter(each -> each.isShowing() && "shortcuts".equals(each.getName()))
        .count();
  }

  /** Returns what the tab key goes through. */
  private static Set<Component> reached(Container frame) {
    FocusTraversalPolicy order = frame.getFocusTraversalPolicy();
    Set<Component> reached = new LinkedHashSet<>();
    Component at = order.getFirstComponent(frame);
    while (reached.add(at)) {
      at = order.getComponentAfter(frame, at);
    }
    return reached;
  }

  private static void walk(Component at, Set<Component> reached, List<String> nameless) {
    boolean arrow = at.getParent() instanceof JScrollBar;
    boolean used = KINDS.stream().anyMatch(kind -> kind.isInstance(at)) && !arrow;
    if (at instanceof JComponent part && (reached.contains(at) || used)) {
      AccessibleContext context = part.getAccessibleContext();
      String name = context == null ? null : context.getAccessibleName();
      if (name == null || name.isBlank()) {
        nameless.add(at.toString());
      }
    }
    if (at instanceof Container inner) {
      for (Component each : inner.getComponents()) {
        walk(each, reached, nameless);
      }
    }
  }
}
