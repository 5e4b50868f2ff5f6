package glint.desktop.window;

import java.nio.file.Path;
import java.util.Map;

/**
 * What the window has others do for it; immutable.
 *
 * @param scenes reads scene files
 * @param images writes and reads images
 * @param state the file of what is remembered; made when it is needed
 * @param cache the folder of small pictures; made when it is needed
 * @param environment the variables that name the user's editor
 */
public record Desk(
    SceneSource scenes,
    ImageStore images,
    Path state,
    Path cache,
    Map<String, String> environment) {

  /** Copies the variables. */
  public Desk {
    environment = Map.copyOf(environment);
  }
}
