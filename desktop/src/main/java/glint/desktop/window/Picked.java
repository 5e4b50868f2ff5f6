package glint.desktop.window;

import glint.scene.Scene;
import java.nio.file.Path;

/**
 * A scene to choose; immutable.
 *
 * @param file where it was read
 */
public record Picked(Path file, Scene scene) {}
