package glint.desktop.window;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** All files that were read: their scenes, and what is wrong with them. */
final class Library {

  private final Map<Path, SceneSource.Found> files = new LinkedHashMap<>();

  /** Takes what a file holds now; of what is broken now, the scenes stay as they were. */
  void put(Path file, SceneSource.Found found) {
    SceneSource.Found before = files.get(file);
    List<Picked> scenes = new ArrayList<>(found.scenes());
    if (before != null && !found.problems().isEmpty()) {
      for (Picked old : before.scenes()) {
        if (scenes.stream().noneMatch(old::isVersionOf)) {
          scenes.add(old);
        }
      }
    }
    files.put(file, new SceneSource.Found(scenes, found.problems(), found.parts()));
  }

  /** Returns all scenes, by file in the order of opening. */
  List<Picked> scenes() {
    return files.values().stream().flatMap(found -> found.scenes().stream()).toList();
  }

  /** Returns what is wrong, a line each. */
  List<String> problems() {
    return files.values().stream().flatMap(found -> found.problems().stream()).toList();
  }
}
