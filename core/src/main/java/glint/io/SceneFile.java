package glint.io;

import glint.scene.Scene;
import java.util.List;

/**
 * What was read from one file; immutable.
 *
 * @param scenes the scenes without a problem, in file order
 * @param broken the names of the scenes that are left out, in file order
 * @param problems what is wrong, in file order, then within its models; a scene that any of it
 *     concerns is left out
 * @param notes what was assumed or left unused, in file order; the scenes are rendered
 */
public record SceneFile(
    List<Scene> scenes, List<String> broken, List<Problem> problems, List<Problem> notes) {

  /** Copies the lists. */
  public SceneFile {
    scenes = List.copyOf(scenes);
    broken = List.copyOf(broken);
    problems = List.copyOf(problems);
    notes = List.copyOf(notes);
  }
}
