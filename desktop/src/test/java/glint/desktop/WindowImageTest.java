package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import glint.desktop.window.SceneSource;
import glint.image.Comparison;
import glint.image.Image;
import glint.io.Pfm;
import glint.report.Errors;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.JSlider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Saves, copies, compares and maps the image in a window. */
@Tag("window")
class WindowImageTest {

  private static final SceneSource SOURCE =
      file -> WindowCommand.read(file, new PrintWriter(Writer.nullWriter()));

  @TempDir private Path dir;
  private Path file;
  private Path out;

  /** The batch renders two scenes: the window's, and one to compare it with. */
  @BeforeEach
  void render() throws Exception {
    file = Scenes.write(dir.resolve("a.yaml"), "one", "two");
    out = dir.resolve("out");
    Run.of("render", file, "--out", out, "--format", "both", "--aov", "error,samples");
  }

  @Test
  void anImageIsSavedAsTheBatchDoes() throws Exception {
    Path batch = dir.resolve("batch");
    Run.of("render", file, "--out", batch);
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      screen.hands().command(KeyEvent.VK_S);
      screen.choose(dir.resolve("saved.png"));
      screen.await(
          "the PNG", () -> screen.text("notice").equals("saved " + dir.resolve("saved.png")));
      assertArrayEquals(bytes(batch.resolve("one.png")), bytes(dir.resolve("saved.png")));
      screen.hands().command(KeyEvent.VK_S);
      screen.choose(dir.resolve("saved.pfm"));
      screen.await("the PFM", () -> screen.text("notice").endsWith("saved.pfm"));
      assertArrayEquals(bytes(out.resolve("one.pfm")), bytes(dir.resolve("saved.pfm")));
      screen.hands().command(KeyEvent.VK_S);
      screen.choose(dir.resolve("missing").resolve("saved.png"));
      screen.await("why not", () -> screen.text("notice").startsWith("cannot save: "));
      assertTrue(screen.text("notice").endsWith("no such file or folder"), screen.text("notice"));
    }
  }

  @Test
  void whatIsShownIsCopied() throws Exception {
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      screen.hands().command(KeyEvent.VK_C);
      screen.await("the notice", () -> screen.text("notice").equals("copied 40x30 pixels"));
      Object copied =
          Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.imageFlavor);
      int[] codes = ((BufferedImage) copied).getRGB(0, 0, 40, 30, null, 0, 40);
      assertArrayEquals(batch(0), codes);
    }
  }

  @Test
  void anotherImageStandsBesideOrIsSubtractedAndMeasured() throws Exception {
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_B);
      screen.choose(out.resolve("two.pfm"));
      screen.await("a measure", () -> screen.text("metrics").startsWith("RMSE"));
      Image two = pfm("two");
      Image one = WindowTest.image(SOURCE.read(file).scenes().get(0).scene());
      Comparison c = Comparison.of(one, two, Transfer.SRGB);
      assertTrue(
          screen
              .text("metrics")
              .startsWith(
                  String.format(
                      Locale.ROOT,
                      "RMSE %.3g levels, largest %.3g;",
                      c.levelsRmse(),
                      c.levelsMax())),
          screen.text("metrics"));
      JSlider divider = screen.part("divider", JSlider.class);
      EventThread.on(
          () -> {
            divider.setValue(0);
            return null;
          });
      screen.awaitShown("the other", () -> Arrays.equals(two.toArgb(Transfer.SRGB), shown(screen)));
      EventThread.on(
          () -> {
            divider.setValue(divider.getMaximum());
            return null;
          });
      screen.awaitShown("the render", () -> Arrays.equals(batch(0), shown(screen)));
      screen.hands().key(KeyEvent.VK_X);
      int[] order = order(Errors.ofPixels(one, two, Transfer.SRGB));
      screen.awaitShown("the difference", () -> isRising(shown(screen), order));
    }
  }

  @Test
  void mapsAreBrighterWherePixelsTookOrClaimMore() throws Exception {
    try (OnScreen screen = new OnScreen(List.of(file), SOURCE)) {
      screen.awaitStatus("done");
      for (String map : List.of("error", "samples")) {
        screen.hands().key(map.equals("error") ? KeyEvent.VK_E : KeyEvent.VK_N);
        double[] rgb = pfm("one." + map).rgb();
        int[] order = order(IntStream.range(0, 1200).mapToDouble(i -> rgb[3 * i]).toArray());
        screen.awaitShown(map, () -> isRising(shown(screen), order));
      }
      screen.hands().key(KeyEvent.VK_P);
      screen.awaitShown("the picture", () -> Arrays.equals(batch(0), shown(screen)));
    }
  }

  private static int[] order(double[] values) {
    return IntStream.range(0, values.length)
        .boxed()
        .sorted((i, j) -> Double.compare(values[i], values[j]))
        .mapToInt(i -> i)
        .toArray();
  }

  /** The palette's green never falls. */
  private static boolean isRising(int[] shown, int[] order) {
    return IntStream.range(1, order.length)
        .allMatch(i -> (shown[order[i - 1]] >> 8 & 255) <= (shown[order[i]] >> 8 & 255));
  }

  private int[] batch(int scene) {
    return WindowTest.batch(SOURCE.read(file).scenes().get(scene).scene());
  }

  private Image pfm(String name) throws Exception {
    try (InputStream in = Files.newInputStream(out.resolve(name + ".pfm"))) {
      return Pfm.read(in, name);
    }
  }

  private static int[] shown(OnScreen screen) {
    screen.hands().key(KeyEvent.VK_1);
    Component view = screen.part("picture", JComponent.class);
    return screen.middle(view, 40, 30);
  }

  private static byte[] bytes(Path path) throws Exception {
    return Files.readAllBytes(path);
  }
}
