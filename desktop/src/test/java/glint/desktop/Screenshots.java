package glint.desktop;

import glint.desktop.window.SceneSource;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;

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
    for (String theme : List.of("light", "dark")) {
      Path gallery = SCENES.resolve("gallery.yaml");
      try (OnScreen screen = new OnScreen(List.of(gallery), SOURCE)) {
        screen.awaitStatus("rendering");
        if (theme.equals("dark")) {
          screen.key(KeyEvent.VK_D);
        }
        new Screenshots(folder, theme + "-" + arguments[1], screen).take(broken);
      }
    }
    System.exit(0);
  }

  private void take(Path broken) throws Exception {
    screen.awaitStatus("done");
    shoot("1-picture");
    screen.key(KeyEvent.VK_E);
    shoot("2-error");
    screen.key(KeyEvent.VK_N);
    shoot("3-samples");
    screen.key(KeyEvent.VK_P);
    screen.key(KeyEvent.VK_F1);
    shoot("6-keys");
    screen.key(KeyEvent.VK_ESCAPE);
    screen.focus();
    screen.key(KeyEvent.VK_M);
    screen.await("the speed", () -> screen.text("measuring").equals("done"));
    shoot("5-speed");
    screen.drop(screen.frame(), List.of(broken));
    screen.key(KeyEvent.VK_DOWN);
    screen.awaitStatus("rendering");
    shoot("4-problems");
  }

  private void shoot(String state) throws IOException, InterruptedException {
    Thread.sleep(400); // what was asked for is drawn
    Path file = folder.resolve(state + "-" + suffix + ".png");
    ImageIO.write(screen.shot(), "png", file.toFile());
    System.out.println(file);
  }
}
