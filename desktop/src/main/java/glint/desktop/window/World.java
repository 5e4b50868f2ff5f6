package glint.desktop.window;

import glint.scene.Prepared;
import glint.scene.Scene;

/** A scene that is prepared once for all pictures of it; thread-safe. */
final class World {

  private final Scene scene;
  private Prepared prepared;

  /** Prepares nothing yet. */
  World(Scene scene) {
    this.scene = scene;
  }

  /** Returns the scene as it was written. */
  Scene scene() {
    return scene;
  }

  /** Returns a picture of it, ready to be rendered; the first call takes its time. */
  synchronized Prepared seenIn(Scene picture) {
    if (prepared == null) {
      prepared = Prepared.of(scene);
    }
    return prepared.seenIn(picture);
  }
}
