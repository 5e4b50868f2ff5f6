package glint.desktop.window;

import java.nio.file.Path;
import java.util.List;

/** Reads files; called on a thread of its own. */
public interface SceneSource {

  /**
   * What files hold; immutable.
   *
   * @param scenes the good ones, in order
   * @param problems what is wrong, a line each, beginning with the file's name
   */
  record Found(List<Picked> scenes, List<String> problems) {

    /** Copies the lists. */
    public Found {
      scenes = List.copyOf(scenes);
      problems = List.copyOf(problems);
    }
  }

  /** Reads files; what cannot be read is a problem. */
  Found read(List<Path> files);
}
