package glint.scene;

import glint.accel.Intersector;
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
  private final Intersector search;
  private final Ray ray = new Ray();
  private final Ray way = new Ray();
  private final Hit hit = new Hit();

  /** The nearest places, by placement, where the ray goes in and where it comes out. */
  private final Map<Integer, Hit> entries = new TreeMap<>();

  private final Map<Integer, Hit> exits = new TreeMap<>();

  /** For each placement, whether it is a body: closed, and with a medium behind some part. */
  private final boolean[] isBody;

  private final Set<Integer> outside = new TreeSet<>();

  /** The nearest ways out of the bodies around the point. */
  private final Map<Integer, Hit> inside = new TreeMap<>();

  EyeMedia(Prepared scene, Primitives primitives, Intersector search) {
    this.search = search;
    this.scene = scene;
    this.primitives = primitives;
    isBody = new boolean[scene.scene().placements().size()];
    for (int surface = 0; surface < scene.surfaces(); surface++) {
      isBody[scene.place(surface)] |=
          scene.mediumOf(surface) != Prepared.OUTSIDE && !scene.isOpen(surface);
    }
  }

  /** Returns the media around a point, outermost first. */
  int[] around(Vector3d point) {
    for (int i = 0; i < 6; i++) {
      double[] d = new double[3];
      d[i / 2] = i % 2 == 0 ? 1 : -1;
      ray.set(point.x(), point.y(), point.z(), d[0], d[1], d[2]);
      ray.time = 0.5;
      look();
      decide();
    }
    // Of two bodies, one in the other, the inner one is left first.
    List<Hit> ways = new ArrayList<>(inside.values());
    ways.sort(Comparator.comparing((Hit way) -> way.t).reversed());
    return ways.stream().mapToInt(way -> scene.mediumOf(way.surface)).toArray();
  }

  private void look() {
    entries.clear();
    exits.clear();
    for (int slot = 0; slot < primitives.count(); slot++) {
      int place = scene.place(primitives.surface(slot));
      if (isBody[place] && !outside.contains(place)) {
        look(slot, place);
      }
    }
  }

  /** Keeps the nearest hits with a primitive: one, or of an instance one of each kind. */
  private void look(int slot, int place) {
    boolean entered = false;
    boolean left = false;
    way.copy(ray);
    do {
      hit.begin(Double.POSITIVE_INFINITY);
      search.intersect(slot, way, hit);
      if (hit.found() && hit.crossing != 0) {
        entered |= hit.crossing > 0;
        left |= hit.crossing < 0;
        keep(place, hit, hit.crossing > 0 ? entries : exits);
      }
      way.goOnAfter(hit);
    } while (primitives.isInstance(slot) && hit.found() && !(entered && left));
  }

  private static void keep(int place, Hit hit, Map<Integer, Hit> nearest) {
    Hit kept = nearest.get(place);
    if (kept == null) {
      kept = new Hit();
      nearest.put(place, kept);
    } else if (kept.t <= hit.t) {
      return;
    }
    kept.copy(hit);
  }

  private void decide() {
    exits.forEach(
        (place, exit) -> {
          Hit entry = entries.get(place);
          // An opaque part of a body does not tell what is in it
          if (isBefore(exit, entry) && scene.mediumOf(exit.surface) != Prepared.OUTSIDE) {
            inside.merge(place, exit, (a, b) -> a.t <= b.t ? a : b);
          }
        });
    entries.forEach(
        (place, entry) -> {
          if (isBefore(entry, exits.get(place)) && !inside.containsKey(place)) {
            outside.add(place);
          }
        });
  }

  /** Returns whether a hit is nearer than another, if there is one, beyond all rounding. */
  private boolean isBefore(Hit hit, Hit other) {
    search.resolve(ray, hit);
    return other == null || hit.t + hit.clearance(ray) < other.t;
  }
}
