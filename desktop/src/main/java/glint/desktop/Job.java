package glint.desktop;

import glint.scene.Scene;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;

/**
 * A scene that was read and shall be rendered; immutable.
 *
 * @param file where it was read
 * @param modified when that file, or a model that it names, was last changed
 * @param digest a hash of the file's bytes and of its models', in hex
 * @param loadSeconds its share of the time that reading the file took
 */
record Job(Path file, FileTime modified, String digest, double loadSeconds, Scene scene) {

  /** Returns a job for each picture: for each frame of a turntable, or only this one. */
  List<Job> pictures() {
    List<Scene> frames = scene.frames();
    double seconds = loadSeconds / frames.size();
    return frames.stream().map(s -> new Job(file, modified, digest, seconds, s)).toList();
  }
}
