package glint.scene;

/** A scene that is prepared once for all pictures of it; thread-safe. */
public final class World {

  private final Scene scene;
  private Prepared prepared;

  /** Prepares nothing yet. */
  public World(Scene scene) {
    this.scene = scene;
  }

  /** Returns the scene as it was written. */
  public Scene scene() {
    return scene;
  }

  /**
   * Returns a picture of it, ready to be rendered; the first call takes its time.
   *
   * @throws IllegalArgumentException if the picture shows another world
   */
  public synchronized Prepared seenIn(Scene picture) {
    if (prepared == null) {
      prepared = Prepared.of(scene);
    }
    return prepared.seenIn(picture);
  }
}
