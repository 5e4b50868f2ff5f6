package glint.io;

/**
 * Divides polygons of the plane, which run counter-clockwise, into triangles by clipping ears (G.
 * Meisters, Polygons have ears, American Mathematical Monthly 82, 1975).
 *
 * <p>Decisions are exact, so that n - 2 triangles cover a simple polygon once, whatever its corners
 * on straight edges. Where a polygon touches or crosses itself and no ear is left, the rules are
 * relaxed in three steps, the last of which takes anything.
 */
final class EarClipper {

  /** What became of a polygon. */
  enum Outcome {
    /** Triangles cover it, once if it is simple. */
    DIVIDED,
    /** Its edges cross in a way that left no ear, so that triangles may overlap. */
    CROSSED,
    /** Dividing it would take too long. */
    GIVEN_UP
  }

  /** How many comparisons all polygons of one file may take: about a second. */
  private static final long MOST_WORK = 1L << 27;

  private static final int STRICT = 0;
  private static final int TOUCHING = 1;
  private static final int CROSSING = 2;

  private final FlatPolygon polygon;
  private final Blockers blockers;
  private int[] previous = {};
  private int[] next = {};

  /** A ring of corners that may be ears, each at most once. */
  private int[] queue = {};

  private boolean[] queued = {};
  private int head;
  private int waiting;

  EarClipper(FlatPolygon polygon) {
    this.polygon = polygon;
    blockers = new Blockers(polygon);
  }

  /** Divides the polygon of at least four corners; writes three of them for each triangle. */
  Outcome clip(int[] triangles) {
    link();
    blockers.begin();
    int left = polygon.size();
    int used = 0;
    int end = 0;
    int level = STRICT;
    for (; left > 3; level++) {
      queueAll(end, left);
      while (waiting > 0 && left > 3) {
        if (polygon.work() > MOST_WORK) {
          return Outcome.GIVEN_UP;
        }
        int b = unqueue();
        int a = previous[b];
        int c = next[b];
        if (isEar(a, b, c, level)) {
          used = put(triangles, used, a, b, c);
          cut(a, b, c);
          left--;
          end = a;
        }
      }
    }
    put(triangles, used, previous[end], end, next[end]);
    return level - 1 >= CROSSING ? Outcome.CROSSED : Outcome.DIVIDED;
  }

  private static int put(int[] triangles, int at, int a, int b, int c) {
    triangles[at] = a;
    triangles[at + 1] = b;
    triangles[at + 2] = c;
    return at + 3;
  }

  private boolean isEar(int a, int b, int c, int level) {
    if (level > CROSSING) {
      return true;
    }
    int turn = polygon.turn(a, b, c);
    return switch (level) {
      case STRICT -> turn > 0 && !blockers.isBlocked(a, b, c, true);
      case TOUCHING -> turn == 0 || turn > 0 && !blockers.isBlocked(a, b, c, false);
      default -> turn > 0;
    };
  }

  private void link() {
    int n = polygon.size();
    if (n > next.length) {
      int length = Math.max(n, 2 * next.length);
      previous = new int[length];
      next = new int[length];
      queue = new int[length];
      queued = new boolean[length];
    }
    for (int i = 0; i < n; i++) {
      previous[i] = i == 0 ? n - 1 : i - 1;
      next[i] = i + 1 == n ? 0 : i + 1;
      queued[i] = false;
    }
    head = 0;
    waiting = 0;
  }

  /** Takes a corner out, after which its neighbours may be ears. */
  private void cut(int a, int b, int c) {
    next[a] = c;
    previous[c] = a;
    blockers.remove(b);
    renew(a);
    renew(c);
  }

  private void renew(int corner) {
    if (blockers.blocks(corner) && polygon.turn(previous[corner], corner, next[corner]) > 0) {
      blockers.remove(corner);
    }
    enqueue(corner);
  }

  /** Queues every second corner before the others, which makes rounder triangles than a fan. */
  private void queueAll(int start, int left) {
    int corner = start;
    for (int i = 0; i < 2 * left; i++) {
      if (i % 2 == 0 || i >= left) {
        enqueue(corner);
      }
      corner = next[corner];
    }
  }

  private void enqueue(int corner) {
    if (!queued[corner]) {
      int at = head + waiting;
      queue[at < queue.length ? at : at - queue.length] = corner;
      queued[corner] = true;
      waiting++;
    }
  }

  private int unqueue() {
    int corner = queue[head];
    head = head + 1 < queue.length ? head + 1 : 0;
    queued[corner] = false;
    waiting--;
    return corner;
  }
}
