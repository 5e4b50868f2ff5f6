package glint.desktop;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import picocli.CommandLine;

/** What one command of {@code glint} printed and returned. */
record Run(int exitCode, String out, String err) {

  /** Runs a command in this process; each argument is taken by its toString. */
  static Run of(Object... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine glint = Main.commandLine().setOut(new PrintWriter(out, true));
    glint.setErr(new PrintWriter(err, true));
    String[] words = Arrays.stream(args).map(Object::toString).toArray(String[]::new);
    return new Run(glint.execute(words), out.toString(), err.toString());
  }

  /** Returns the lines of standard error. */
  List<String> errLines() {
    return err.lines().toList();
  }

  /** Returns the names of all files in a folder, hidden ones included; none if it is missing. */
  static List<String> list(Path folder) throws IOException {
    if (!Files.exists(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(f -> f.getFileName().toString()).sorted().toList();
    }
  }

  /** Returns the digests of all files in a folder by name. */
  static Map<String, String> digests(Path folder) throws IOException {
    Map<String, String> digests = new TreeMap<>();
    for (String name : list(folder)) {
      digests.put(name, Digests.of(folder.resolve(name)));
    }
    return digests;
  }
}
