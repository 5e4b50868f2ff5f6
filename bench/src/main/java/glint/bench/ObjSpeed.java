package glint.bench;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * Prints how fast OBJ models load, and how much heap that takes, beside javagl's reader.
 *
 * <p>Every figure comes from processes of its own on one processor with the serial collector. A
 * mesh counts 24 bytes a point and 12 a triangle, what Glint keeps of it. Peak is the most heap in
 * use where there is plenty, garbage not yet collected included; least is the smallest heap in
 * which the model loads at all, all of the JVM's own objects included.
 */
public final class ObjSpeed {

  private static final double MB = 1e6;
  private static final double MIB = 1 << 20;
  private static final int PLENTY = 4096;

  private ObjSpeed() {}

  /** Measures the models that are named. */
  public static void main(String[] args) throws IOException, InterruptedException {
    System.out.println("| model | text | mesh | reader | speed | peak heap | least heap |");
    System.out.println("|---|---|---|---|---|---|---|");
    for (String arg : args) {
      Path file = Path.of(arg);
      double text = Files.size(file) / MB;
      double mesh = meshBytes(file) / MB;
      for (String reader : List.of("glint", "javagl")) {
        double speed = text / run(reader, "seconds", file, PLENTY).get(0);
        double peak = run(reader, "peak", file, PLENTY).get(0) / MB;
        double least = leastHeap(reader, file) * MIB / MB;
        System.out.printf(
            Locale.ROOT,
            "| %s | %.1f MB | %.1f MB | %s | %.0f MB/s | %.2f meshes | %.2f meshes |%n",
            file.getFileName(),
            text,
            mesh,
            reader,
            speed,
            peak / mesh,
            least / mesh);
      }
    }
  }

  private static double meshBytes(Path file) throws IOException {
    try (Stream<String> points = Files.lines(file);
        Stream<String> faces = Files.lines(file)) {
      return 24.0 * points.filter(line -> line.startsWith("v ")).count()
          + 12.0 * faces.filter(line -> line.startsWith("f ")).count();
    }
  }

  /** Returns the least heap in MiB, by halving. */
  private static int leastHeap(String reader, Path file) throws IOException, InterruptedException {
    int tooLittle = 1;
    int enough = PLENTY;
    while (enough - tooLittle > 1) {
      int heap = (enough + tooLittle) / 2;
      if (run(reader, "once", file, heap).isEmpty()) {
        tooLittle = heap;
      } else {
        enough = heap;
      }
    }
    return enough;
  }

  /** Runs {@link ObjLoad}; returns the number that it prints, or nothing if it fails. */
  private static List<Double> run(String reader, String what, Path file, int heap)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:ActiveProcessorCount=1", "-Xmx" + heap + "m"));
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), ObjLoad.class.getName()));
    command.addAll(List.of(reader, what, file.toString()));
    Process process = new ProcessBuilder(command).redirectError(Redirect.DISCARD).start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return process.waitFor() == 0 ? List.of(Double.parseDouble(out.trim())) : List.of();
  }
}
