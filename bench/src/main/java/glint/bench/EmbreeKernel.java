package glint.bench;

import java.io.BufferedOutputStream;
import java.io.BufferedReader;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Embree 3, one ray at a time, in a process of its own that is told what to trace. */
final class EmbreeKernel implements Kernel {

  private final PrintWriter to;
  private final BufferedReader from;

  private EmbreeKernel(Process process) {
    to = new PrintWriter(process.outputWriter(StandardCharsets.US_ASCII), true);
    from =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.US_ASCII));
  }

  /** Adds it if g++ and Embree are there. */
  static void add(float[] corners, List<Rays> all, Path sources, List<Kernel> kernels) {
    try {
      Path folder = Files.createTempDirectory("glint-embree");
      Path program = folder.resolve("embree");
      Path source = sources.resolve("embree.cpp").toAbsolutePath();
      ProcessBuilder compiler =
          new ProcessBuilder(
              "g++", "-O2", source.toString(), "-o", program.toString(), "-lembree3");
      if (compiler.inheritIO().start().waitFor() != 0) {
        throw new IOException("it does not compile");
      }
      write(corners, folder.resolve("mesh"));
      for (Rays rays : all) {
        rays.write(folder.resolve(rays.kind()));
      }
      ProcessBuilder embree = new ProcessBuilder(program.toString()).directory(folder.toFile());
      kernels.add(new EmbreeKernel(embree.redirectError(ProcessBuilder.Redirect.INHERIT).start()));
    } catch (IOException | InterruptedException e) {
      System.err.println("without Embree (g++ and Debian's package libembree-dev): " + e);
    }
  }

  private static void write(float[] corners, Path file) throws IOException {
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file), 1 << 16))) {
      for (float v : corners) {
        out.writeFloat(v);
      }
    }
  }

  @Override
  public String name() {
    return "Embree 3, rtcIntersect1";
  }

  @Override
  public Took trace(Rays rays) throws IOException {
    to.println((rays.any() ? "any " : "closest ") + rays.kind());
    String[] answer = String.valueOf(from.readLine()).split(" ");
    if (answer.length != 2) {
      throw new IOException("Embree ended");
    }
    return new Took(Double.parseDouble(answer[0]), Integer.parseInt(answer[1]));
  }
}
