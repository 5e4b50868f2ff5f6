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
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.function.BooleanSupplier;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.ListCellRenderer;
import javax.swing.SwingUtilities;
import javax.swing.TransferHandler;

/** A real window, driven by mouse and keyboard and read off the screen. */
final class OnScreen implements AutoCloseable {

  private static final int PATIENCE_MILLIS = 30_000;

  private final GlintWindow window;
  private final JFrame frame;
  private final Robot robot;

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
  }

  /** Returns the surroundings of a window that keeps everything in one folder. */
  static Desk desk(SceneSource source, Path home, Map<String, String> environment) {
    Path state = home.resolve("state").resolve("window.properties");
    return new Desk(source, new WindowImages(), state, home.resolve("cache"), environment);
  }

  JFrame frame() {
    return frame;
  }

  Robot robot() {
    return robot;
  }

  /** Returns the part of the window with a name. */
  <C extends Component> C part(String name, Class<C> kind) {
    return kind.cast(on(() -> find(frame, name)));
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
    return on(label::getText);
  }

  /** Returns what a line of a list says, from 0. */
  <T> String line(JList<T> list, int index) {
    return on(
        () -> {
          T value = list.getModel().getElementAt(index);
          ListCellRenderer<? super T> cells = list.getCellRenderer();
          Component cell = cells.getListCellRendererComponent(list, value, index, false, false);
          return ((JLabel) cell).getText();
        });
  }

  /** Waits until something is so. */
  void await(String what, BooleanSupplier condition) throws InterruptedException {
    awaitShown(what, () -> on(condition::getAsBoolean));
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

  /** Presses and lets go of a key. */
  void key(int code) {
    robot.keyPress(code);
    robot.keyRelease(code);
    robot.waitForIdle();
  }

  /** Presses a key while the one is held that goes with commands. */
  void command(int code) {
    int control = KeyEvent.VK_CONTROL;
    robot.keyPress(control);
    key(code);
    robot.keyRelease(control);
    robot.waitForIdle();
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
    on(
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
    click(part("status", JLabel.class));
    await("the focus", frame::isFocused);
  }

  /** Moves the pointer to a place in a part. */
  void moveTo(Component part, int x, int y) {
    Point corner = on(part::getLocationOnScreen);
    robot.mouseMove(corner.x + x, corner.y + y);
    robot.waitForIdle();
  }

  /** Clicks on the middle of a part. */
  void click(Component part) {
    click(part, part.getWidth() / 2, part.getHeight() / 2);
  }

  /** Clicks on a place in a part. */
  void click(Component part, int x, int y) {
    moveTo(part, x, y);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    robot.waitForIdle();
  }

  /** Drags from a place in a part to another, in some steps. */
  void drag(Component part, Point from, Point to, int buttonMask) {
    moveTo(part, from.x, from.y);
    robot.mousePress(buttonMask);
    for (int i = 1; i <= 5; i++) {
      moveTo(part, from.x + (to.x - from.x) * i / 5, from.y + (to.y - from.y) * i / 5);
    }
    robot.mouseRelease(buttonMask);
    robot.waitForIdle();
  }

  /** Does something while a key is down. */
  void with(int key, Runnable work) {
    robot.keyPress(key);
    work.run();
    robot.keyRelease(key);
    robot.waitForIdle();
  }

  /** Clicks twice on a place in a part. */
  void doubleClick(Component part, int x, int y) {
    moveTo(part, x, y);
    for (int i = 0; i < 2; i++) {
      robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
      robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }
    robot.waitForIdle();
  }

  /** Hands files to a window as a drop does; returns whether it took them. */
  boolean drop(JFrame onto, List<Path> files) {
    Transferable offer =
        new Transferable() {
          @Override
          public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
          }

          @Override
          public boolean isDataFlavorSupported(DataFlavor flavor) {
            return DataFlavor.javaFileListFlavor.equals(flavor);
          }

          @Override
          public Object getTransferData(DataFlavor flavor) {
            return files.stream().map(Path::toFile).toList();
          }
        };
    TransferHandler.TransferSupport support = new TransferHandler.TransferSupport(onto, offer);
    return on(() -> onto.getTransferHandler().importData(support));
  }

  /** Turns the wheel over a part, away from the user if negative. */
  void wheel(int notches) {
    robot.mouseWheel(notches);
    robot.waitForIdle();
  }

  /** Returns what the screen shows in the middle of a part. */
  int[] middle(Component part, int width, int height) {
    robot.waitForIdle();
    Point corner = on(part::getLocationOnScreen);
    int x = corner.x + (int) Math.rint((part.getWidth() - width) / 2.0);
    int y = corner.y + (int) Math.rint((part.getHeight() - height) / 2.0);
    BufferedImage shot = robot.createScreenCapture(new Rectangle(x, y, width, height));
    return shot.getRGB(0, 0, width, height, null, 0, width);
  }

  /** Returns the whole window as the screen shows it. */
  BufferedImage shot() {
    robot.waitForIdle();
    return robot.createScreenCapture(on(frame::getBounds));
  }

  /** Returns what the event thread makes of something. */
  static <T> T on(Callable<T> work) {
    if (SwingUtilities.isEventDispatchThread()) {
      try {
        return work.call();
      } catch (Exception e) {
        throw new IllegalStateException(e);
      }
    }
    FutureTask<T> task = new FutureTask<>(work);
    try {
      SwingUtilities.invokeAndWait(task);
      return task.get();
    } catch (InterruptedException
        | InvocationTargetException
        | java.util.concurrent.ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Closes the window and checks that it leaves no thread behind. */
  @Override
  public void close() {
    on(
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
