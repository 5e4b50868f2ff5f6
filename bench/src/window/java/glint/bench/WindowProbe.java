package glint.bench;

import glint.color.Transfer;
import glint.desktop.window.Desk;
import glint.desktop.window.GlintWindow;
import glint.desktop.window.ImageStore;
import glint.desktop.window.Picked;
import glint.desktop.window.SceneSource;
import glint.image.Image;
import glint.render.Statistics;
import glint.scene.Scene;
import java.awt.Component;
import java.awt.Container;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.SwingUtilities;

/**
 * The window with some scenes, measured from outside: when it shows what, and how long it hangs.
 */
final class WindowProbe {

  /** A picture that was shown, and when. */
  record Shown(BufferedImage picture, long nanos) {}

  private static final long PATIENCE_SECONDS = 120;

  private final LinkedBlockingQueue<Shown> shown = new LinkedBlockingQueue<>();
  private final LinkedBlockingQueue<Long> chosen = new LinkedBlockingQueue<>();
  private final LinkedBlockingQueue<Long> done = new LinkedBlockingQueue<>();
  private final Component view;
  private final JList<?> list;

  /** Opens the window; the first scene is chosen once all is listened to. */
  WindowProbe(List<Scene> scenes) throws Exception {
    CountDownLatch listening = new CountDownLatch(1);
    List<Picked> all = scenes.stream().map(s -> new Picked(Path.of("a"), s.name(), s)).toList();
    SceneSource source =
        file -> {
          try {
            listening.await();
          } catch (InterruptedException e) {
            throw new IllegalStateException(e);
          }
          return new SceneSource.Found(all, List.of(), Map.of());
        };
    Path folder = Files.createTempDirectory("glint-window");
    Path state = folder.resolve("state");
    GlintWindow.open(
        List.of(Path.of("a")), new Desk(source, new NoImages(), state, folder, Map.of()));
    view = part("picture", Component.class);
    list = part("scenes", JList.class);
    JLabel status = part("status", JLabel.class);
    SwingUtilities.invokeAndWait(
        () -> {
          list.addListSelectionListener(e -> chosen.add(System.nanoTime()));
          view.addPropertyChangeListener(
              "picture",
              e -> {
                BufferedImage picture = (BufferedImage) e.getNewValue();
                // What is asked for now comes after the painting, which was asked for before.
                SwingUtilities.invokeLater(() -> shown.add(new Shown(picture, System.nanoTime())));
              });
          status.addPropertyChangeListener(
              "text",
              e -> {
                if (e.getNewValue().toString().startsWith("done")) {
                  done.add(System.nanoTime());
                }
              });
        });
    listening.countDown();
  }

  /** Chooses a scene; returns when it was chosen, in the time of {@link System#nanoTime}. */
  long choose(int scene) throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          list.clearSelection();
          chosen.clear();
          done.clear();
          list.setSelectedIndex(scene);
          shown.clear();
        });
    return awaitChosen();
  }

  long awaitChosen() throws InterruptedException {
    return take(chosen);
  }

  /** Returns the next picture that is shown. */
  Shown next() throws InterruptedException {
    return take(shown);
  }

  long awaitDone() throws InterruptedException {
    return take(done);
  }

  private static <T> T take(LinkedBlockingQueue<T> queue) throws InterruptedException {
    T first = queue.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
    if (first == null) {
      throw new IllegalStateException("the window shows nothing");
    }
    return first;
  }

  /** Drags to and fro over the picture for a while; returns the pictures shown meanwhile. */
  List<Shown> drag(double seconds) throws Exception {
    Robot robot = new Robot();
    Point corner = view.getLocationOnScreen();
    int x = corner.x + view.getWidth() / 2;
    int y = corner.y + view.getHeight() / 2;
    robot.mouseMove(x, y);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    shown.clear();
    long end = System.nanoTime() + (long) (seconds * 1e9);
    for (int i = 1; System.nanoTime() < end; i++) {
      robot.mouseMove(x + Math.abs(i % 80 - 40), y + i % 7);
      Thread.sleep(10);
    }
    List<Shown> all = List.copyOf(shown);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    return all;
  }

  /** Neither writes nor reads. */
  private static final class NoImages implements ImageStore {
    @Override
    public void write(Picked picked, Image image, Optional<Statistics> statistics, Path file) {}

    @Override
    public Image read(Path file, Transfer transfer) throws IOException {
      throw new IOException("there are no images here");
    }
  }

  private <C extends Component> C part(String name, Class<C> kind) {
    for (Frame frame : Frame.getFrames()) {
      Component found = find(frame, name);
      if (found != null) {
        return kind.cast(found);
      }
    }
    throw new IllegalStateException("the window has no " + name);
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

  /** Reads the gallery. */
  static List<Scene> gallery(String file) {
    try {
      return Scenes.read(Path.of(file));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
