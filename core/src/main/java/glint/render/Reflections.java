package glint.render;

import glint.math.Transform;
import glint.trace.Sight;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** To where flat mirrors seem to move the world, and which of them enough corners show. */
final class Reflections {

  /** The most that are told apart. */
  private static final int MOST = 64;

  /** Two are one and the same if they differ by no more than this share. */
  private static final double SAME = 0x1p-20;

  /** One of them, and how many corners show it. */
  private static final class Reflection {
    final Transform moved;
    int corners;

    Reflection(Transform moved) {
      this.moved = moved;
    }
  }

  private final List<Reflection> all = new ArrayList<>();

  /** What is seen by the same mirrors, those before the last one left out and so on included. */
  private final Map<Long, List<Reflection>> ways = new HashMap<>();

  /** Counts so many corners that show a sight; not if there are too many reflections. */
  void add(Sight sight, int corners) {
    List<Reflection> seen = new ArrayList<>();
    for (int count = 0; count <= sight.count(); count++) {
      Reflection reflection = find(sight.moved(count));
      if (reflection == null) {
        return;
      }
      seen.add(reflection);
    }
    seen.forEach(each -> each.corners += corners);
    ways.put(sight.mirrors(), seen);
  }

  private Reflection find(Transform moved) {
    for (Reflection each : all) {
      if (isSame(each.moved, moved)) {
        return each;
      }
    }
    if (all.size() == MOST) {
      return null;
    }
    Reflection found = new Reflection(moved);
    all.add(found);
    return found;
  }

  private static boolean isSame(Transform a, Transform b) {
    double[] one = a.rows();
    double[] two = b.rows();
    double far = Math.max(Math.abs(one[3]), Math.max(Math.abs(one[7]), Math.abs(one[11])));
    for (int i = 0; i < one.length; i++) {
      if (Math.abs(one[i] - two[i]) > SAME * (i % 4 == 3 ? far : 1)) {
        return false;
      }
    }
    return true;
  }

  /** Returns those that so many corners show. */
  List<Transform> shownBy(long corners) {
    List<Transform> shown = new ArrayList<>();
    for (Reflection each : all) {
      if (each.corners >= corners) {
        shown.add(each.moved);
      }
    }
    return shown;
  }

  /** Returns whether so many corners show each of those by which something is seen. */
  boolean areShownBy(long corners, long mirrors) {
    List<Reflection> seen = ways.get(mirrors);
    return seen != null && seen.stream().allMatch(each -> each.corners >= corners);
  }
}
