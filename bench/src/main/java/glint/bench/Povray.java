package glint.bench;

import glint.image.Image;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** POV-Ray 3.7, as an outside program. */
final class Povray {

  private final Path folder;
  private final Path log;

  /**
   * Sets it up.
   *
   * @param folder where its scenes lie
   * @param log takes what it has to say
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

  /**
   * Renders NAME.pov: one ray through the centre of every pixel, linear, 16 bits a channel.
   *
   * @param law the value of the scene's variable {@code Law}
   */
  Image render(String name, int width, int height, int law) throws IOException {
    Path out = Files.createTempFile(log.getParent(), name, ".ppm");
    List<String> command = new ArrayList<>(List.of("povray", "+I" + name + ".pov", "+O" + out));
    command.addAll(List.of("+W" + width, "+H" + height, "+FP16", "File_Gamma=1.0"));
    command.addAll(List.of("-A", "-D", "+WT1", "Declare=Law=" + law));
    run(command);
    try (InputStream in = Files.newInputStream(out)) {
      return read(new DataInputStream(in));
    } finally {
      Files.delete(out);
    }
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
  private static Image read(DataInputStream in) throws IOException {
    String magic = word(in);
    Image image = new Image(Integer.parseInt(word(in)), Integer.parseInt(word(in)));
    double white = Integer.parseInt(word(in));
    if (!magic.equals("P6") || white < 256) {
      throw new IOException(String.format(Locale.ROOT, "no 16-bit PPM: %s %.0f", magic, white));
    }
    for (int i = 0; i < image.rgb().length; i++) {
      image.rgb()[i] = in.readUnsignedShort() / white;
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
