package glint.scene;

import glint.geometry.Mesh;
import java.util.HashSet;
import java.util.Set;

/** How much memory a scene will take in the form that rays touch, before it is given that form. */
public final class Footprint {

  /** A triangle's nine coordinates and numbers, and a node of the tree. */
  private static final long TRIANGLE = 8 * 9 + 16 + 56;

  /** The same of any other surface, and of a mesh's place: at most two transforms and as much. */
  private static final long OTHER = 400;

  private Footprint() {}

  /** Returns a bound on {@link Prepared#geometryBytes}, seldom more than twice as much. */
  public static long of(Scene scene) {
    SharedMeshes shared = new SharedMeshes(scene);
    Set<Mesh> counted = new HashSet<>();
    long bytes = 0;
    for (Placement each : scene.placements()) {
      bytes += OTHER;
      if (each.surface() instanceof Mesh mesh && (!shared.isInstance(each) || counted.add(mesh))) {
        bytes += TRIANGLE * mesh.triangles();
      }
    }
    return bytes;
  }
}
