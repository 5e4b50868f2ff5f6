package glint.desktop.window;

import glint.scene.Scene;
import java.nio.file.Path;

/**
 * A scene to choose; immutable.
 *
 * @param file where it was read
 * @param digest a hash of all that was read for it, in hex
 */
public record Picked(Path file, String digest, Scene scene) {

  /** Returns whether another is the same scene of the same file, as it was or is. */
  boolean isVersionOf(Picked other) {
    return file.equals(other.file) && scene.name().equals(other.scene.name());
  }
}
