package glint.bench;

import glint.scene.Scene;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Prints how soon the window shows each scene of the gallery, how it keeps up with a moving camera,
 * and how long its event thread hangs.
 */
public final class WindowTable {

  /** So long the camera is moved, after it was moved as long to warm up. */
  private static final double SECONDS = 1;

  private WindowTable() {}

  /**
   * Measures the window on the display.
   *
   * @param args the commit and the scene file, or the scene file and the number of one scene, of
   *     which the time to the first picture is printed
   */
  public static void main(String[] args) {
    int code = 1;
    try {
      List<Scene> scenes = WindowProbe.gallery(args[1]);
      if (args[0].equals("first")) {
        WindowProbe probe = new WindowProbe(List.of(scenes.get(Integer.parseInt(args[2]))));
        System.out.println(first(probe, probe.awaitChosen()));
      } else {
        print(args[0], args[1], scenes);
      }
      code = 0;
    } catch (Exception e) {
      e.printStackTrace();
    }
    System.exit(code); // the event thread goes on
  }

  private static void print(String commit, String file, List<Scene> scenes) throws Exception {
    System.out.println(Machine.with(commit) + ", load " + Machine.load());
    System.out.println();
    System.out.println(
        "| scene | first picture, cold | warm | done | longest work | wait |"
            + " moving | longest work | wait |");
    System.out.println("|---|---|---|---|---|---|---|---|---|");
    WindowProbe probe = new WindowProbe(scenes);
    EventWaits waits = new EventWaits();
    probe.awaitChosen();
    probe.awaitDone();
    for (int i = 0; i < scenes.size(); i++) {
      row(probe, waits, scenes.get(i), i, cold(file, i));
    }
  }

  private static double first(WindowProbe probe, long chosen) throws InterruptedException {
    return (probe.next().nanos() - chosen) * 1e-6;
  }

  /** Returns the milliseconds to the first picture in a Java that has just begun. */
  private static double cold(String file, int scene) throws Exception {
    List<String> words = new ArrayList<>();
    words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    words.addAll(List.of("-cp", System.getProperty("java.class.path")));
    words.addAll(List.of(WindowTable.class.getName(), "first", file, Integer.toString(scene)));
    Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (process.waitFor() != 0) {
      throw new IllegalStateException(out);
    }
    return Double.parseDouble(out.trim());
  }

  private static void row(WindowProbe probe, EventWaits waits, Scene scene, int i, double cold)
      throws Exception {
    take(waits);
    long chosen = probe.choose(i);
    double warm = first(probe, chosen);
    double done = (probe.awaitDone() - chosen) * 1e-9;
    String still = take(waits);
    probe.drag(SECONDS);
    take(waits);
    List<WindowProbe.Shown> moved = probe.drag(SECONDS);
    String moving = take(waits);
    int width = moved.get(moved.size() - 1).picture().getWidth();
    System.out.printf(
        Locale.ROOT,
        "| %s | %.0f ms | %.0f ms | %.1f s | %s | %.0f/s of %d %% | %s |%n",
        scene.name(),
        cold,
        warm,
        done,
        still,
        moved.size() / SECONDS,
        Math.round(100.0 * width / scene.width()),
        moving);
  }

  private static String take(EventWaits waits) {
    return String.format(Locale.ROOT, "%.0f ms | %.0f ms", waits.takeWork(), waits.takeWait());
  }
}
