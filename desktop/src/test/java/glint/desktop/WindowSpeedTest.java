package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.desktop.window.SceneSource;
import java.awt.event.KeyEvent;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JButton;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Measures speed against error in a window. */
@Tag("window")
class WindowSpeedTest {

  private static final SceneSource SOURCE =
      file -> WindowCommand.read(file, new PrintWriter(Writer.nullWriter()));

  @TempDir private Path dir;

  @Test
  void measuringIsCancelledByAnotherSceneAndByItsButton() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      JButton button = screen.part("measure", JButton.class);
      screen.hands().key(KeyEvent.VK_M);
      screen.await("a first image", () -> screen.text("measuring").startsWith("image"));
      assertEquals("Cancel", button.getText());
      screen.hands().key(KeyEvent.VK_DOWN);
      screen.await("two", () -> screen.frame().getTitle().startsWith("two"));
      screen.awaitStatus("done");
      assertEquals("Measure", button.getText());
      screen.hands().click(button);
      screen.await("a first image", () -> screen.text("measuring").startsWith("image"));
      screen.hands().click(button);
      assertEquals("cancelled", screen.text("measuring"));
    }
  }
}
