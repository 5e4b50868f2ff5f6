package glint.bench;

import glint.geometry.Mesh;
import glint.image.Image;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** POV-Ray 3.7, as an outside program. */
final class Povray {

  private static final Pattern CPU_SECONDS = Pattern.compile("with ([0-9.]+) CPU-seconds");

  private final Path folder;
  private final Path log;

  /**
   * Sets it up.
   *
   * @param folder where its scenes lie
   * @param log takes what it has to say; files beside it can be included in scenes
   */
  Povray(Path folder, Path log) {
    this.folder = folder.toAbsolutePath();
    this.log = log.toAbsolutePath();
  }

  /**
   * Returns its version.
   *
   * @throws IOException if there is none
   */
  String version() throws IOException {
    try {
      run(List.of("povray", "--version"));
    } catch (IOException e) {
      throw new IOException(
          "povray was not found: install Debian's package povray, or POV-Ray 3.7");
    }
    for (String line : Files.readAllLines(log)) {
      if (line.startsWith("POV-Ray ")) {
        return line;
      }
    }
    throw new IOException("povray does not say its version: see " + log);
  }

  /** Writes the triangles of a mesh to NAME.inc beside the log. */
  void write(Mesh mesh, String name) throws IOException {
    try (PrintStream out =
        new PrintStream(
            new BufferedOutputStream(Files.newOutputStream(log.resolveSibling(name + ".inc"))),
            false,
            StandardCharsets.US_ASCII)) {
      out.println("mesh {");
      double[] c = new double[9];
      for (int i = 0; i < mesh.triangles(); i++) {
        mesh.corners(i, c);
        out.println("triangle { " + point(c, 0) + point(c, 3) + point(c, 6) + "}");
      }
      out.println("}");
      if (out.checkError()) {
        throw new IOException(name + ".inc could not be written");
      }
    }
  }

  private static String point(double[] c, int at) {
    return "<" + c[at] + "," + c[at + 1] + "," + c[at + 2] + "> ";
  }

  /**
   * Renders NAME.pov: one ray through the centre of every pixel, linear, 16 bits a channel.
   *
   * @param law the value of the scene's variable {@code Law}
   */
  Image render(String name, int width, int height, int law) throws IOException {
    return render(name, width, height, 1, List.of("-A", "Declare=Law=" + law));
  }

  /**
   * Renders NAME.pov on one thread, linear, 16 bits a channel.
   *
   * @param finer the mean of so many by so many pixels is one of the image
   * @param options what else it is told
   */
  Image render(String name, int width, int height, int finer, List<String> options)
      throws IOException {
    Path out = Files.createTempFile(log.getParent(), name, ".ppm");
    List<String> command = new ArrayList<>(List.of("povray", "+I" + name + ".pov", "+O" + out));
    command.addAll(List.of("+W" + finer * width, "+H" + finer * height));
    command.addAll(
        List.of("+L" + log.getParent(), "+FP16", "File_Gamma=1.0", "-D", "-V", "-J", "+WT1"));
    command.addAll(options);
    run(command);
    try (InputStream in = new BufferedInputStream(Files.newInputStream(out))) {
      return read(new DataInputStream(in), finer);
    } finally {
      Files.delete(out);
    }
  }

  /** Returns the CPU seconds of tracing the last image, by its own account. */
  double traceSeconds() throws IOException {
    List<String> lines = Files.readAllLines(log);
    for (int i = 0; i + 1 < lines.size(); i++) {
      Matcher seconds = CPU_SECONDS.matcher(lines.get(i + 1));
      if (lines.get(i).contains("Trace Time:") && seconds.find()) {
        return Double.parseDouble(seconds.group(1));
      }
    }
    throw new IOException("povray does not say how long it traced: see " + log);
  }

  private void run(List<String> command) throws IOException {
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    Process process = builder.redirectErrorStream(true).redirectOutput(log.toFile()).start();
    try {
      if (process.waitFor() != 0) {
        throw new IOException(String.join(" ", command) + " failed: see " + log);
      }
    } catch (InterruptedException e) {
      process.destroy();
      throw new IOException("interrupted", e);
    }
  }

  /** Reads a portable pixel map (ppm(5) of Netpbm) of 16 bits a channel. */
  private static Image read(DataInputStream in, int finer) throws IOException {
    String magic = word(in);
    int width = Integer.parseInt(word(in));
    int height = Integer.parseInt(word(in));
    double white = Integer.parseInt(word(in));
    if (!magic.equals("P6") || white < 256) {
      throw new IOException(String.format(Locale.ROOT, "no 16-bit PPM: %s %.0f", magic, white));
    }
    Image image = new Image(width / finer, height / finer);
    double share = 1 / (white * finer * finer);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int at = 3 * (y / finer * image.width() + x / finer);
        for (int channel = 0; channel < 3; channel++) {
          image.rgb()[at + channel] += share * in.readUnsignedShort();
        }
      }
    }
    return image;
  }

  /** Reads a word of the header, and the one white space or the comment after it. */
  private static String word(DataInputStream in) throws IOException {
    StringBuilder word = new StringBuilder();
    for (int c = in.readUnsignedByte(); c > ' ' || word.length() == 0; c = in.readUnsignedByte()) {
      if (c == '#') {
        while (in.readUnsignedByte() != '\n') {}
      } else if (c > ' ') {
        word.append((char) c);
      }
    }
    return word.toString();
  }
}
