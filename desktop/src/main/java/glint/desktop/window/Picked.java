package glint.desktop.window;

import glint.scene.Scene;
import java.nio.file.Path;

/**
 * A scene to choose; immutable.
 *
 * @param file where it was read
 */
public record Picked(Path file, Scene scene) {

  /** Returns the name, by which a list is searched when one types. */
  @Override
  public String toString() {
    return scene.name();
  }
}
