package glint.scene;

import glint.accel.Intersector;

/** What tests in other packages ask of a prepared scene. */
public final class PreparedFacts {

  private PreparedFacts() {}

  /** Returns a search that tries everything. */
  public static Intersector scan(Prepared scene) {
    return new Intersector(scene.primitives());
  }
}
