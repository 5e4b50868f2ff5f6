package glint.scene;

import glint.geometry.Mesh;
import glint.math.Transform;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * The meshes that stand at several places of a scene: they are kept once, in their own space, and
 * rays are carried to them.
 */
final class SharedMeshes {

  /** Where a transform flattens more, its triangles are carried into the world, not the rays. */
  private static final double MOST_FLATTENED = 0x1p20;

  /** With lengths and factors up to these, no product of coordinates overflows in any space. */
  private static final double LARGEST_COORDINATE = 0x1p266;

  private static final double LARGEST_FACTOR = 0x1p160;

  private final Set<Mesh> shared = new HashSet<>();

  SharedMeshes(Scene scene) {
    Map<Mesh, Integer> places = new HashMap<>();
    for (Placement p : scene.placements()) {
      if (p.surface() instanceof Mesh mesh && isGentle(p)) {
        int before = places.merge(mesh, 1, Integer::sum);
        if (before > 1 && mesh.size() <= LARGEST_COORDINATE) {
          shared.add(mesh);
        }
      }
    }
  }

  /** Returns whether rays may be carried to a placement, which does not move either. */
  private static boolean isGentle(Placement p) {
    Transform t = p.toWorld();
    return !p.isMoving()
        && t.flattening() <= MOST_FLATTENED
        && t.largest() <= LARGEST_FACTOR
        && t.inverted().largest() <= LARGEST_FACTOR;
  }

  /** Returns how many meshes are shared. */
  int count() {
    return shared.size();
  }

  /** Returns whether a placement shows a shared mesh, rather than having its own triangles. */
  boolean isInstance(Placement p) {
    return p.surface() instanceof Mesh mesh && shared.contains(mesh) && isGentle(p);
  }
}
