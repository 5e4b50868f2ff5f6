package glint.desktop.window;

import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;

/** Reads scene files; called on a thread of its own. */
public interface SceneSource {

  /**
   * What a file holds; immutable.
   *
   * @param scenes the good ones, in order
   * @param problems what is wrong, a line each, beginning with a file's name
   * @param parts all files that were looked for, and when each was last changed
   */
  record Found(List<Picked> scenes, List<String> problems, Map<Path, FileTime> parts) {

    /** Copies the collections. */
    public Found {
      scenes = List.copyOf(scenes);
      problems = List.copyOf(problems);
      parts = Map.copyOf(parts);
    }
  }

  /** Reads a file; what cannot be read is a problem. */
  Found read(Path file);
}
