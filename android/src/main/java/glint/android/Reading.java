package glint.android;

import glint.scene.Scene;
import java.util.List;

/**
 * What was read from a file; immutable.
 *
 * @param name what the file is called
 * @param digest a hash of the file's bytes, in hex
 * @param scenes those without a problem
 * @param problems what is wrong, a line each
 */
record Reading(String name, String digest, List<Scene> scenes, List<String> problems) {

  /** Copies the lists. */
  Reading {
    scenes = List.copyOf(scenes);
    problems = List.copyOf(problems);
  }
}
