package glint.desktop;

import glint.io.Problem;
import glint.io.SceneFile;
import glint.io.SceneFiles;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads scene files from disk, and the models that they name. */
final class Inputs {

  private final List<Job> jobs = new ArrayList<>();
  private final List<Failed> problems = new ArrayList<>();
  private final List<String> notes = new ArrayList<>();
  private final Map<Path, FileTime> parts = new LinkedHashMap<>();
  private int broken;

  private Inputs() {}

  /**
   * Reads files, the good scenes of each and what is wrong with the others; {@code err} is for
   * traces.
   */
  static Inputs read(List<Path> files, PrintWriter err) {
    Inputs inputs = new Inputs();
    for (Path file : files) {
      try {
        inputs.read(file);
      } catch (IOException e) {
        inputs.fail(file, Reasons.of(file, e));
      } catch (RuntimeException | OutOfMemoryError | StackOverflowError e) {
        inputs.fail(file, file + ": " + Reasons.of(e));
        Reasons.trace(e, err);
      }
    }
    return inputs;
  }

  /** Returns the scenes that were read, in order. */
  List<Job> jobs() {
    return jobs;
  }

  /** Returns how many scenes could not be read. */
  int broken() {
    return broken;
  }

  /**
   * Returns what is wrong, each by its file (and the scenes of it that are left out) and with a
   * whole line.
   */
  List<Failed> problems() {
    return problems;
  }

  /** Returns what was assumed or left unused, a line each, beginning with the file's name. */
  List<String> notes() {
    return notes;
  }

  /** Returns all files that were looked for, and when each was last changed. */
  Map<Path, FileTime> parts() {
    return parts;
  }

  private void fail(Path file, String line) {
    problems.add(new Failed(file.toString(), line));
  }

  private void read(Path file) throws IOException {
    if (Files.isDirectory(file)) {
      throw new IOException("is a folder, not a scene file");
    }
    long began = System.nanoTime();
    ModelFolder folder = new ModelFolder(file, parts);
    MessageDigest digest = Digests.begin();
    SceneFile content;
    try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
      content = SceneFiles.read(in, file.toString(), folder);
    }
    broken += content.broken().size();
    String scenes = String.join(", ", content.broken());
    String name = scenes.isEmpty() ? file.toString() : file + " (" + scenes + ")";
    content.problems().forEach(problem -> problems.add(new Failed(name, problem.toString())));
    for (Problem n : content.notes()) {
      notes.add(new Problem(n.file(), n.line(), n.column(), "note: " + n.message()).toString());
    }
    if (content.scenes().isEmpty() && content.problems().isEmpty()) {
      fail(file, file + ": holds no scene");
    }
    FileTime modified = folder.newest();
    String hash = folder.digest(Digests.end(digest));
    double seconds = (System.nanoTime() - began) * 1e-9 / Math.max(1, content.scenes().size());
    content.scenes().forEach(s -> jobs.add(new Job(file, modified, hash, seconds, s)));
  }
}
