package glint.scene;

import glint.geometry.Hit;
import glint.geometry.Primitives;
import glint.geometry.Ray;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Finds the closed bodies that a point is inside of: those that a ray from it leaves before it
 * enters them.
 *
 * <p>Six directions are tried for each body. One that only touches it, or meets an edge where some
 * of its faces look towards the point and some away, decides nothing.
 */
final class EyeMedia {

  private final Prepared scene;
  private final Primitives primitives;
  private final Ray ray = new Ray();
  private final Ray local = new Ray();

  /** The nearest places, by surface, where the ray goes in and where it comes out. */
  private final Map<Integer, Hit> entries = new TreeMap<>();

  private final Map<Integer, Hit> exits = new TreeMap<>();

  private final Set<Integer> outside = new TreeSet<>();

  /** The bodies around the point, and how near it is to leaving them. */
  private final Map<Integer, Double> inside = new TreeMap<>();

  EyeMedia(Prepared scene, Primitives primitives) {
    this.scene = scene;
    this.primitives = primitives;
  }

  /** Returns the media around a point, outermost first. */
  int[] around(Vector3d point) {
    for (int i = 0; i < 6; i++) {
      double[] d = new double[3];
      d[i / 2] = i % 2 == 0 ? 1 : -1;
      ray.set(point.x(), point.y(), point.z(), d[0], d[1], d[2]);
      look();
      decide();
    }
    // Of two bodies, one in the other, the inner one is left first.
    List<Integer> surfaces = new ArrayList<>(inside.keySet());
    surfaces.sort(Comparator.comparing(inside::get).reversed());
    return surfaces.stream().mapToInt(scene::mediumOf).toArray();
  }

  private void look() {
    entries.clear();
    exits.clear();
    Hit hit = new Hit();
    for (int slot = 0; slot < primitives.count(); slot++) {
      int surface = primitives.surface(slot);
      boolean body = scene.mediumOf(surface) != Prepared.OUTSIDE && !scene.isOpen(surface);
      if (body && !outside.contains(surface)) {
        hit.begin(Double.POSITIVE_INFINITY);
        primitives.intersect(slot, ray, hit, local);
        if (hit.found() && hit.crossing != 0) {
          keep(surface, hit, hit.crossing > 0 ? entries : exits);
        }
      }
    }
  }

  private static void keep(int surface, Hit hit, Map<Integer, Hit> nearest) {
    Hit kept = nearest.get(surface);
    if (kept == null) {
      kept = new Hit();
      nearest.put(surface, kept);
    } else if (kept.t <= hit.t) {
      return;
    }
    kept.copy(hit);
  }

  private void decide() {
    exits.forEach(
        (surface, exit) -> {
          Hit entry = entries.get(surface);
          if (entry == null || isBefore(exit, entry)) {
            inside.merge(surface, exit.t, Math::min);
          }
        });
    entries.forEach(
        (surface, entry) -> {
          Hit exit = exits.get(surface);
          if ((exit == null || isBefore(entry, exit)) && !inside.containsKey(surface)) {
            outside.add(surface);
          }
        });
  }

  /** Returns whether a hit is nearer than another beyond all rounding. */
  private boolean isBefore(Hit hit, Hit other) {
    primitives.resolve(ray, hit, local);
    return hit.t + hit.clearance(ray) < other.t;
  }
}
