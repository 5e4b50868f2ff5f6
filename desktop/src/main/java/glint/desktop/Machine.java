package glint.desktop;

import glint.desktop.report.Report;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Collectors;

/** Finds out on what Glint runs. */
final class Machine {

  private Machine() {}

  /** Returns what a report says of it; the commit is known where a build names it. */
  static Report.Environment environment(int threads) {
    String options =
        ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(option -> option.startsWith("-X"))
            .collect(Collectors.joining(" "));
    String java = System.getProperty("java.vm.name") + " " + Version.java() + " " + options;
    String commit = System.getProperty("glint.commit", "");
    return new Report.Environment(Version.glint(), commit, java.trim(), machine(), threads);
  }

  private static String machine() {
    return String.format(
        Locale.ROOT,
        "%s, %s, %s",
        processor(),
        Figures.count(Runtime.getRuntime().availableProcessors(), "core"),
        System.getProperty("os.name"));
  }

  /** Returns the processor's name where the system tells it, else its kind. */
  private static String processor() {
    try {
      for (String line : Files.readAllLines(Path.of("/proc/cpuinfo"))) {
        if (line.startsWith("model name")) {
          return line.substring(line.indexOf(':') + 1).trim();
        }
      }
    } catch (IOException e) {
      return System.getProperty("os.arch");
    }
    return System.getProperty("os.arch");
  }
}
