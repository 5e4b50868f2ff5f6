package glint.android;

import glint.scene.Prepared;
import glint.scene.Scene;

/** What all pictures of one scene have in common, once it is prepared; used by one thread. */
final class World {

  private Prepared prepared;

  /** Prepares a picture of the scene; only the first takes time. */
  Prepared prepare(Scene picture) {
    prepared = prepared == null ? Prepared.of(picture) : prepared.seenIn(picture);
    return prepared;
  }
}
