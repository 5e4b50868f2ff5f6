package glint.desktop;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The statistics of a run as JSON; the names are a contract with scripts. */
record StatsFile(
    String version,
    String java,
    int threads,
    List<SceneStats> scenes,
    List<Failed> failed,
    boolean interrupted) {

  private static final Gson GSON =
      new GsonBuilder().serializeNulls().disableHtmlEscaping().setPrettyPrinting().create();

  /** Checks, before a long run, that the file can be written. */
  static void check(Path file) throws RunException {
    if (Files.isDirectory(file)) {
      throw new RunException("cannot write " + file + ": is a folder");
    }
    Folders.make(file.toAbsolutePath().getParent());
  }

  /** Writes the file, whole or not at all. */
  void write(Path file) throws RunException {
    try {
      AtomicFile.write(file, path -> Files.writeString(path, GSON.toJson(this) + "\n"));
    } catch (IOException e) {
      throw new RunException("cannot write " + Reasons.of(file, e), e);
    }
  }
}
