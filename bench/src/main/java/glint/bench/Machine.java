package glint.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** What a figure was measured on. */
final class Machine {

  private static final Path CPU = Path.of("/proc/cpuinfo");

  private static final Path LOAD = Path.of("/proc/loadavg");

  private Machine() {}

  /** Returns how many threads wanted to run in the last minute, as far as the machine says it. */
  static String load() throws IOException {
    return Files.isReadable(LOAD) ? Files.readString(LOAD).split(" ")[0] : "unknown";
  }

  /** Returns commit, Java, and the machine: as far as it says what it is. */
  static String with(String commit) throws IOException {
    String cpu = System.getProperty("os.arch");
    if (Files.isReadable(CPU)) {
      for (String line : Files.readAllLines(CPU)) {
        if (line.startsWith("model name")) {
          cpu = line.substring(line.indexOf(':') + 1).trim();
        }
      }
    }
    return String.format(
        Locale.ROOT,
        "commit %s, Java %s, %s %s, %d × %s",
        commit,
        System.getProperty("java.version"),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        Runtime.getRuntime().availableProcessors(),
        cpu);
  }
}
