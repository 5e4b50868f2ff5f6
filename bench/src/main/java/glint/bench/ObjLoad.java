package glint.bench;

import com.sun.management.OperatingSystemMXBean;
import glint.io.ObjModel;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Loads a model in a process of its own, for {@link ObjSpeed}, and prints one number.
 *
 * <p>Arguments: the reader, what to measure, the file. {@code seconds} is the median CPU time of
 * the whole process over warm loads, collection of garbage included; {@code peak} is the most bytes
 * of heap in use during the first load; {@code once} is the number of triangles.
 */
public final class ObjLoad {

  private static final int WARM_UP = 8;
  private static final int TIMED = 15;

  private ObjLoad() {}

  /** Measures and prints. */
  public static void main(String[] args) throws IOException {
    Path file = Path.of(args[2]);
    boolean ours = args[0].equals("glint");
    switch (args[1]) {
      case "seconds" -> System.out.println(seconds(ours, file));
      case "peak" -> System.out.println(peak(ours, file));
      default -> System.out.println(load(ours, file));
    }
  }

  /** Returns the number of triangles. */
  private static int load(boolean ours, Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      if (!ours) {
        return de.javagl.obj.ObjReader.read(in).getNumFaces();
      }
      ObjModel model = glint.io.ObjReader.read(in, file.toString());
      return model.mesh().triangles();
    }
  }

  private static double seconds(boolean ours, Path file) throws IOException {
    OperatingSystemMXBean system =
        (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    double[] seconds = new double[TIMED];
    for (int i = -WARM_UP; i < TIMED; i++) {
      long before = system.getProcessCpuTime();
      load(ours, file);
      seconds[Math.max(i, 0)] = (system.getProcessCpuTime() - before) * 1e-9;
    }
    Arrays.sort(seconds);
    return seconds[TIMED / 2];
  }

  private static long peak(boolean ours, Path file) throws IOException {
    List<MemoryPoolMXBean> heap =
        ManagementFactory.getMemoryPoolMXBeans().stream()
            .filter(pool -> pool.getType() == MemoryType.HEAP)
            .collect(Collectors.toList());
    System.gc();
    long before = heap.stream().mapToLong(pool -> pool.getUsage().getUsed()).sum();
    heap.forEach(MemoryPoolMXBean::resetPeakUsage);
    load(ours, file);
    return heap.stream().mapToLong(pool -> pool.getPeakUsage().getUsed()).sum() - before;
  }
}
