package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import glint.desktop.window.SceneSource;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import javax.swing.JComponent;
import javax.swing.JList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Edits files that a window has open. */
@Tag("window")
class WindowEditTest {

  private static final SceneSource SOURCE =
      file -> WindowCommand.read(file, new PrintWriter(Writer.nullWriter()));

  @TempDir private Path dir;

  @Test
  void savingRendersAgainAndTheLastGoodImageStaysWhileAFileIsBroken() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    String good = Files.readString(file);
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      JList<?> list = screen.part("scenes", JList.class);
      JList<?> problems = screen.part("problems", JList.class);
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_DOWN);
      screen.await("two", () -> screen.frame().getTitle().startsWith("two"));
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_1);
      int[] before = shown(screen);
      Files.writeString(file, good.replace("radius: 1", "radius: 0"));
      screen.await("the problem", () -> problems.getModel().getSize() == 2);
      assertEquals(2, list.getModel().getSize());
      screen.hands().key(KeyEvent.VK_1);
      assertArrayEquals(before, shown(screen));
      Files.writeString(file, good.replace("radius: 1", "radius: 0.5"));
      screen.awaitShown("another image", () -> !Arrays.equals(before, shown(screen)));
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_1);
      assertArrayEquals(batch(file, 1), shown(screen));
      assertEquals(0, problems.getModel().getSize());
      assertEquals(1, list.getSelectedIndex());
    }
  }

  @Test
  void whatASceneFileNamesIsWatchedToo() throws Exception {
    Path model = dir.resolve("model.obj");
    String triangle = "v -1 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n";
    Files.writeString(model, triangle);
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    Files.writeString(file, Files.readString(file) + "      - mesh: {file: model.obj}\n");
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_1);
      int[] before = shown(screen);
      Files.writeString(model, triangle.replace("v 0 2 0", "v 0 5 0"));
      screen.awaitShown("another image", () -> !Arrays.equals(before, shown(screen)));
      screen.awaitStatus("done");
      assertArrayEquals(batch(file, 0), shown(screen));
    }
  }

  @Test
  void aClickOnAProblemOpensItsPlace() throws Exception {
    assumeTrue(Files.getFileStore(dir).supportsFileAttributeView("posix"));
    Path opened = dir.resolve("opened");
    Path editor = Files.writeString(dir.resolve("code"), "#!/bin/sh\necho \"$@\" >> " + opened);
    Files.setPosixFilePermissions(editor, PosixFilePermissions.fromString("rwx------"));
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    Files.writeString(file, Files.readString(file).replace("radius: 1", "radius: 0"));
    Map<String, String> environment = Map.of("VISUAL", editor + " --wait");
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE, environment)) {
      JList<?> problems = screen.part("problems", JList.class);
      screen.await("the problem", () -> problems.getModel().getSize() == 1);
      String line = problems.getModel().getElementAt(0).toString();
      screen.await("its place", problems::isShowing);
      screen.hands().click(problems);
      screen.await("the editor", () -> Files.exists(opened));
      screen.await("its line", () -> read(opened).endsWith("\n"));
      String command = read(opened).trim();
      assertTrue(command.startsWith("--goto " + file) && command.matches(".*:[0-9]+:[0-9]+"));
      assertTrue(line.startsWith(command.substring("--goto ".length()) + ": "), line);
    }
  }

  private static int[] shown(OnScreen screen) {
    Component view = screen.part("picture", JComponent.class);
    return screen.middle(view, 40, 30);
  }

  private static int[] batch(Path file, int scene) {
    return WindowTest.batch(SOURCE.read(file).scenes().get(scene).scene());
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (java.io.IOException e) {
      throw new IllegalStateException(e);
    }
  }
}
