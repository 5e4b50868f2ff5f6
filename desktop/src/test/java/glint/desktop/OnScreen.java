package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import glint.desktop.window.Desk;
import glint.desktop.window.GlintWindow;
import glint.desktop.window.SceneSource;
import java.awt.Component;
import java.awt.Container;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.ListCellRenderer;

/** A real window, driven by hands and read off the screen. */
final class OnScreen implements AutoCloseable {

  private static final int PATIENCE_MILLIS = 30_000;

  private final GlintWindow window;
  private final JFrame frame;
  private final Robot robot;
  private final Hands hands;

  /** Opens a window that remembers nothing; skips the test where there is no display. */
  OnScreen(List<Path> files, SceneSource source) throws Exception {
    this(files, source, Map.of());
  }

  /** Opens such a window where some variables are set. */
  OnScreen(List<Path> files, SceneSource source, Map<String, String> environment) throws Exception {
    this(files, desk(source, Files.createTempDirectory("glint"), environment));
  }

  /** Opens a window; skips the test where there is no display. */
  OnScreen(List<Path> files, Desk desk) throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "no display: see tools/xvfb.sh");
    window = GlintWindow.open(files, desk);
    frame =
        (JFrame)
            Arrays.stream(Frame.getFrames()).filter(Frame::isDisplayable).findFirst().orElseThrow();
    robot = new Robot();
    robot.setAutoDelay(20);
    hands = new Hands(robot);
    await("the keyboard", () -> frame.getFocusOwner() != null);
  }

  /** Returns the surroundings of a window that keeps everything in one folder. */
  static Desk desk(SceneSource source, Path home, Map<String, String> environment) {
    Path state = home.resolve("state").resolve("window.properties");
    return new Desk(source, new WindowImages(), state, home.resolve("cache"), environment);
  }

  JFrame frame() {
    return frame;
  }

  Hands hands() {
    return hands;
  }

  /** Returns the part of the window with a name. */
  <C extends Component> C part(String name, Class<C> kind) {
    return kind.cast(EventThread.on(() -> find(frame, name)));
  }

  private static Component find(Container in, String name) {
    for (Component each : in.getComponents()) {
      Component found =
          name.equals(each.getName()) ? each : each instanceof Container c ? find(c, name) : null;
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  /** Returns what a label says. */
  String text(String name) {
    JLabel label = part(name, JLabel.class);
    return EventThread.on(label::getText);
  }

  /** Returns what a line of a list says, from 0. */
  <T> String line(JList<T> list, int index) {
    return EventThread.on(
        () -> {
          T value = list.getModel().getElementAt(index);
          ListCellRenderer<? super T> cells = list.getCellRenderer();
          Component cell = cells.getListCellRendererComponent(list, value, index, false, false);
          return ((JLabel) cell).getText();
        });
  }

  /** Waits until something is so. */
  void await(String what, BooleanSupplier condition) throws InterruptedException {
    awaitShown(what, () -> EventThread.on(condition::getAsBoolean));
  }

  /** Waits until something is so that the event thread cannot tell, such as what is on screen. */
  void awaitShown(String what, BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE_MILLIS * 1_000_000L;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, () -> what + " never came: " + text("status"));
      Thread.sleep(10);
    }
  }

  void awaitStatus(String beginning) throws InterruptedException {
    await(beginning, () -> text("status").startsWith(beginning));
  }

  /** Waits for a dialog that asks for a file, and answers it. */
  void choose(Path file) throws InterruptedException {
    JFileChooser[] found = new JFileChooser[1];
    await(
        "a dialog",
        () ->
            Arrays.stream(Window.getWindows())
                .filter(each -> each.isShowing() && each instanceof JDialog)
                .map(each -> ((JDialog) each).getContentPane().getComponent(0))
                .filter(JFileChooser.class::isInstance)
                .anyMatch(each -> (found[0] = (JFileChooser) each) != null));
    EventThread.on(
        () -> {
          found[0].setSelectedFile(file.toFile());
          found[0].approveSelection();
          return null;
        });
    focus();
  }

  /** Gives the keyboard back to the window after a dialog, as a window manager would. */
  void focus() throws InterruptedException {
    await(
        "no dialog",
        () ->
            Arrays.stream(Window.getWindows())
                .filter(JDialog.class::isInstance)
                .noneMatch(Window::isShowing));
    hands.click(part("status", JLabel.class));
    await("the focus", frame::isFocused);
  }

  /** Returns what the screen shows in the middle of a part. */
  int[] middle(Component part, int width, int height) {
    robot.waitForIdle();
    Point corner = EventThread.on(part::getLocationOnScreen);
    int x = corner.x + (int) Math.rint((part.getWidth() - width) / 2.0);
    int y = corner.y + (int) Math.rint((part.getHeight() - height) / 2.0);
    BufferedImage shot = robot.createScreenCapture(new Rectangle(x, y, width, height));
    return shot.getRGB(0, 0, width, height, null, 0, width);
  }

  /** Returns the whole window as the screen shows it. */
  BufferedImage shot() {
    robot.waitForIdle();
    return robot.createScreenCapture(EventThread.on(frame::getBounds));
  }

  /** Closes the window and checks that it leaves no thread behind. */
  @Override
  public void close() {
    EventThread.on(
        () -> {
          frame.dispose();
          return null;
        });
    try {
      window.awaitClosed();
      long end = System.nanoTime() + PATIENCE_MILLIS * 1_000_000L;
      while (!threads().isEmpty() && System.nanoTime() < end) {
        Thread.sleep(20);
      }
    } catch (InterruptedException e) {
      throw new IllegalStateException("nothing interrupts a test", e);
    }
    assertEquals(List.of(), threads());
  }

  private static List<String> threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("glint"))
        .toList();
  }
}
