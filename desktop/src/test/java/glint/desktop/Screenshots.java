package glint.desktop;

import glint.desktop.window.Desk;
import glint.desktop.window.Picked;
import glint.desktop.window.SceneSource;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTabbedPane;

/** Takes pictures of the window in all its states, for people to look at. */
final class Screenshots {

  private static final Path SCENES = Path.of("..", "scenes");
  private static final SceneSource SOURCE =
      file -> WindowCommand.read(file, new PrintWriter(Writer.nullWriter()));

  private final Path folder;
  private final String suffix;
  private final OnScreen screen;

  private Screenshots(Path folder, String suffix, OnScreen screen) {
    this.folder = folder;
    this.suffix = suffix;
    this.screen = screen;
  }

  /** Takes them, into the folder and with the suffix that the arguments name. */
  public static void main(String[] arguments) throws Exception {
    Path folder = Files.createDirectories(Path.of(arguments[0]));
    Path broken = Files.createTempDirectory("glint").resolve("broken.yaml");
    Files.writeString(
        broken,
        """
        scenes:
          ball:
            camera: {position: [0, 2, 6], look_at: [0, 1, 0], fov: 35}
            surfaces:
              - sphere: {center: [0, 1, 0], radios: 1}
              - plane: {point: [0, 0, 0], normal: [0, 0, 0]}
        """);
    Path rough = Files.createTempDirectory("glint");
    Path gallery = SCENES.resolve("gallery.yaml");
    Run.of("render", gallery, "--scene", "sphere-garden", "--samples", "1", "--out", rough);
    Path cache = Files.createTempDirectory("glint");
    for (String theme : List.of("light", "dark")) {
      Path state = rough.resolve(theme);
      Desk desk = new Desk(SOURCE, new WindowImages(), state, cache, Map.of());
      try (OnScreen screen = new OnScreen(List.of(gallery), desk)) {
        screen.awaitStatus("rendering");
        if (theme.equals("dark")) {
          screen.hands().key(KeyEvent.VK_D);
        }
        Screenshots shots = new Screenshots(folder, theme + "-" + arguments[1], screen);
        int scenes = SOURCE.read(gallery).scenes().size();
        for (int i = 0; i < 120 && Run.list(desk.cache()).size() < scenes; i++) {
          Thread.sleep(1000); // until small pictures of all scenes are made
        }
        shots.render();
        shots.look(rough.resolve("sphere-garden.png"));
        shots.edit(broken);
      }
    }
    System.exit(0);
  }

  /** A render on its way, paused, done; what is known of it. */
  private void render() throws Exception {
    pick("checkmate");
    screen.await("an error", () -> screen.text("status").contains("error"));
    screen.hands().key(KeyEvent.VK_SPACE);
    screen.awaitStatus("paused");
    shoot("01-paused");
    screen.hands().key(KeyEvent.VK_SPACE);
    shoot("02-rendering");
    screen.awaitStatus("done");
    shoot("03-done");
    pick("mirror-trio");
    screen.awaitStatus("done");
    screen.hands().key(KeyEvent.VK_M);
    screen.await("the speed", () -> screen.text("measuring").equals("done"));
    shoot("04-speed");
    JTabbedPane side = screen.part("side", JTabbedPane.class);
    Component view = screen.part("picture", JComponent.class);
    screen.hands().click(view);
    screen.await("its rays", () -> side.getSelectedIndex() == 2);
    shoot("13-rays");
    EventThread.on(
        () -> {
          side.setSelectedIndex(0);
          return null;
        });
  }

  /** The other looks of an image. */
  private void look(Path other) throws Exception {
    pick("sphere-garden");
    screen.awaitStatus("done");
    screen.hands().key(KeyEvent.VK_E);
    shoot("05-error");
    screen.hands().key(KeyEvent.VK_N);
    shoot("06-samples");
    screen.hands().key(KeyEvent.VK_B);
    screen.choose(other);
    screen.await("a measure", () -> screen.text("metrics").startsWith("RMSE"));
    shoot("07-split");
    screen.hands().key(KeyEvent.VK_X);
    Thread.sleep(2000);
    shoot("08-difference");
    screen.hands().key(KeyEvent.VK_P);
  }

  /** A broken file; all keys; a menu; a window with little room. */
  private void edit(Path broken) throws Exception {
    screen.hands().drop(screen.frame(), List.of(broken));
    screen.await("a problem", screen.part("problems", JComponent.class)::isShowing);
    shoot("09-problems");
    screen.hands().key(KeyEvent.VK_F1);
    shoot("10-keys");
    screen.hands().key(KeyEvent.VK_ESCAPE);
    screen.focus();
    screen.hands().click(screen.frame().getJMenuBar().getMenu(0));
    shoot("11-menu");
    screen.hands().key(KeyEvent.VK_ESCAPE);
    EventThread.on(
        () -> {
          screen.frame().setSize(800, 500);
          screen.frame().validate();
          return null;
        });
    shoot("12-small");
  }

  private void pick(String name) throws InterruptedException {
    JList<?> list = screen.part("scenes", JList.class);
    EventThread.on(
        () -> {
          for (int i = 0; i < list.getModel().getSize(); i++) {
            Picked each = (Picked) list.getModel().getElementAt(i);
            if (each.scene().name().equals(name)) {
              list.setSelectedIndex(i);
            }
          }
          return null;
        });
    screen.await(name, () -> screen.frame().getTitle().startsWith(name));
    screen.await("its render", () -> !screen.text("status").startsWith("done"));
  }

  private void shoot(String state) throws IOException, InterruptedException {
    Thread.sleep(400); // what was asked for is drawn
    Path file = folder.resolve(state + "-" + suffix + ".png");
    ImageIO.write(screen.shot(), "png", file.toFile());
    System.out.println(file);
  }
}
