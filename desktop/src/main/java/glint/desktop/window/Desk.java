package glint.desktop.window;

import java.util.Map;

/**
 * What the window has others do for it; immutable.
 *
 * @param scenes reads scene files
 * @param images writes and reads images
 * @param environment the variables that name the user's editor
 */
public record Desk(SceneSource scenes, ImageStore images, Map<String, String> environment) {

  /** Copies the variables. */
  public Desk {
    environment = Map.copyOf(environment);
  }
}
