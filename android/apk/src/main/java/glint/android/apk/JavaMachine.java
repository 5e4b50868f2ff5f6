package glint.android.apk;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * A Java machine on which programs run in a process of their own.
 *
 * @param home its folder
 */
record JavaMachine(Path home) {

  /** Returns the one that runs this. */
  static JavaMachine own() {
    return new JavaMachine(Path.of(System.getProperty("java.home")));
  }

  /** Returns its version, as its own folder says. */
  String version() throws IOException {
    for (String line : Files.readAllLines(home.resolve("release"))) {
      if (line.startsWith("JAVA_VERSION=")) {
        return line.substring(line.indexOf('"') + 1, line.lastIndexOf('"'));
      }
    }
    throw new IOException("no version is told in " + home.resolve("release"));
  }

  /**
   * Runs {@link GalleryRun}.
   *
   * @param classPath the harness, and the core to run
   * @param verified false for class files that were translated from dex and so lack what the
   *     verifier needs
   * @return the lines that it prints
   * @throws IOException if it fails; what it said then is the message
   */
  List<String> gallery(List<String> classPath, boolean verified, String... args)
      throws IOException {
    List<String> command = new ArrayList<>();
    command.add(home.resolve("bin/java").toString());
    command.add("-Xmx512m");
    command.add("-XX:+UseParallelGC");
    if (!verified) {
      Collections.addAll(
          command, "-XX:+UnlockDiagnosticVMOptions", "-XX:-BytecodeVerificationRemote");
    }
    Collections.addAll(
        command, "-cp", String.join(File.pathSeparator, classPath), GalleryRun.class.getName());
    Collections.addAll(command, args);
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    List<String> lines = new ArrayList<>();
    try (BufferedReader out =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
      for (String line = out.readLine(); line != null; line = out.readLine()) {
        if (!line.contains("warning:")) { // of a newer machine, that the options go some day
          lines.add(line);
        }
      }
      if (process.waitFor() != 0) {
        throw new IOException(String.join("\n", lines));
      }
    } catch (InterruptedException e) {
      process.destroy();
      throw new IOException("interrupted", e);
    }
    return lines;
  }
}
