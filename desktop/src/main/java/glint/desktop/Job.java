package glint.desktop;

import glint.scene.Scene;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;

/**
 * A scene that was read and shall be rendered; immutable.
 *
 * @param file where it was read
 * @param modified when that file was last changed
 * @param digest SHA-256 of the file's bytes, in hex
 * @param loadSeconds its share of the time that reading the file took
 */
record Job(Path file, FileTime modified, String digest, double loadSeconds, Scene scene) {}
