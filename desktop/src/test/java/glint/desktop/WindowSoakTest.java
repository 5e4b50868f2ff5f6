package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.desktop.window.Desk;
import glint.desktop.window.SceneSource;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A monkey works with a window for a while. */
@Tag("soak")
class WindowSoakTest {

  private static final SceneSource SOURCE =
      file -> WindowCommand.read(file, new PrintWriter(Writer.nullWriter()));

  /** What Swing and the list of small pictures may keep more than at first, in bytes. */
  private static final long MORE = 24 << 20;

  @TempDir private Path dir;

  @Test
  void nothingBreaksAndNothingIsLeft() throws Exception {
    List<String> failures = new CopyOnWriteArrayList<>();
    Thread.setDefaultUncaughtExceptionHandler((thread, e) -> failures.add(trace(thread, e)));
    double minutes = Double.parseDouble(System.getProperty("glint.soak.minutes"));
    Path gallery = Path.of(System.getProperty("glint.gallery"));
    Desk desk = OnScreen.desk(SOURCE, dir.resolve("home"), Map.of());
    Monkey monkey = new Monkey(dir, gallery, desk, 1);
    monkey.work(0.05 * minutes);
    long base = rest(gallery, desk);
    monkey.work(0.95 * minutes);
    long end = rest(gallery, desk);
    Thread.setDefaultUncaughtExceptionHandler(null);
    System.out.printf(
        Locale.ROOT,
        "%d steps, %d windows; heap %.1f MB, at first %.1f MB%n",
        monkey.steps(),
        monkey.windows(),
        end * 0x1p-20,
        base * 0x1p-20);
    assertEquals(List.of(), failures);
    assertTrue(end < base + MORE, end + " bytes are kept, at first " + base);
  }

  /** Returns what a window keeps that shows the first scene and does nothing. */
  private static long rest(Path gallery, Desk desk) throws Exception {
    try (OnScreen screen = new OnScreen(List.of(gallery), desk)) {
      screen.awaitStatus("done");
      long least = Long.MAX_VALUE;
      for (int i = 0; i < 10; i++) {
        System.gc();
        Thread.sleep(300);
        Runtime java = Runtime.getRuntime();
        least = Math.min(least, java.totalMemory() - java.freeMemory());
      }
      return least;
    }
  }

  private static String trace(Thread thread, Throwable e) {
    StringWriter text = new StringWriter();
    e.printStackTrace(new PrintWriter(text, true));
    return thread.getName() + ": " + text;
  }
}
