package glint.android.apk;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Times the core that the desktop runs and that of the app's packages, translated back, on the Java
 * machines beside the one that runs this, and writes the table into docs/android.md.
 */
public final class Timing {

  private static final String BEGIN = "<!-- begin: ./gradlew :android:apk:timing -->\n";
  private static final String END = "<!-- end -->\n";

  /**
   * Columns, rows and error of the images, threads, and renders of each, of which the last counts.
   */
  private static final String[] HOW = {"160", "120", "4", "1", "3"};

  private static final String DESKTOP = "desktop";

  private final Path scenes;
  private final Map<String, List<String>> cores;

  private Timing(Path scenes, Map<String, List<String>> cores) {
    this.scenes = scenes;
    this.cores = cores;
  }

  /**
   * Writes the table.
   *
   * @param args the page; the scene file; the class paths of the harness and of the desktop's core;
   *     the debug and the release package
   */
  public static void main(String[] args) throws IOException {
    Path folder = Files.createTempDirectory("glint-timing");
    String harness = args[2];
    Map<String, List<String>> cores = new LinkedHashMap<>();
    cores.put(DESKTOP, List.of(harness, args[3]));
    for (int i = 4; i < args.length; i++) {
      String type = i == 4 ? "debug app" : "release app";
      Path jar = folder.resolve(i + ".jar");
      DexJar.translate(Path.of(args[i]), jar);
      cores.put(type, List.of(harness, jar.toString()));
    }
    String table = new Timing(Path.of(args[1]), cores).table(machines());
    Path page = Path.of(args[0]);
    String text = Files.readString(page);
    int from = text.indexOf(BEGIN) + BEGIN.length();
    Files.writeString(page, text.substring(0, from) + table + text.substring(text.indexOf(END)));
  }

  /** Returns the installed machines of different versions, in the order of their folders' names. */
  private static List<JavaMachine> machines() throws IOException {
    Map<String, JavaMachine> byVersion = new LinkedHashMap<>();
    byVersion.put(JavaMachine.own().version(), JavaMachine.own());
    try (Stream<Path> beside = Files.list(JavaMachine.own().home().toRealPath().getParent())) {
      for (Path home : beside.sorted().collect(Collectors.toList())) {
        if (Files.isExecutable(home.resolve("bin/java"))) {
          byVersion.putIfAbsent(new JavaMachine(home).version(), new JavaMachine(home));
        }
      }
    }
    return new ArrayList<>(byVersion.values());
  }

  private String table(List<JavaMachine> machines) throws IOException {
    StringBuilder out = new StringBuilder("| |");
    for (JavaMachine each : machines) {
      out.append(" HotSpot ").append(each.version()).append(" |");
    }
    out.append("\n|---|").append("---|".repeat(machines.size())).append('\n');
    for (String core : cores.keySet()) {
      out.append("| ").append(core).append(" |");
      for (JavaMachine each : machines) {
        out.append(String.format(Locale.ROOT, " %.2f s |", seconds(each, core)));
      }
      out.append('\n');
    }
    return out.toString();
  }

  private double seconds(JavaMachine java, String core) throws IOException {
    List<String> args = new ArrayList<>(List.of(scenes.toString()));
    args.addAll(List.of(HOW));
    boolean verified = core.equals(DESKTOP);
    double sum = 0;
    for (String line : java.gallery(cores.get(core), verified, args.toArray(new String[0]))) {
      sum += Double.parseDouble(line.substring(line.lastIndexOf(' ') + 1));
    }
    return sum;
  }
}
