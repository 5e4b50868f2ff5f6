package glint.render;

import glint.scene.Prepared;
import glint.trace.Sight;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Tells corners from every second one, in columns and rows, where those see the same plain thing in
 * the same light and nothing small is between.
 *
 * <p>A square of four such corners is calm if they met the same and no {@link Marks} are there. A
 * corner amid one, or on a side between two, is filled in if levels run evenly along a line through
 * it.
 */
final class CalmCorners {

  /** Every so many columns and rows there is a corner from which others are told. */
  static final int STEP = Marks.STEP;

  /**
   * Second differences along that line are at most this share of the error accepted, so that what
   * lies between is an eighth of that off a straight line. What is filled in follows a cubic, or a
   * parabola, which leave a small part of it; {@link Bends} finds the same bends in it as between
   * all corners.
   */
  private static final double BEND = 0.4;

  /**
   * Where nothing has highlights, light bends as slowly as surfaces and the ways to lights do, and
   * it is by how much second differences change that tells what a cubic leaves: a sixteenth of
   * that. They themselves are at most so many times the root of the error accepted: of a cosine
   * over 20 levels a cubic leaves an eightieth of their square.
   */
  private static final double CURVE = 2;

  /** Projections are as dear as a few rays: more than one for so many corners do not pay. */
  private static final int CORNERS_PER_OUTLINE = 24;

  /** In images with fewer corners so little is plain that it is not worth looking for it. */
  private static final int LEAST = 1 << 14;

  /** The same is seen in a mirror made of more parts as if it were not there. */
  private static final int PARTS = 16;

  private final Prepared scene;
  private final CornerGrid corners;
  private final LevelScale scale;
  private final float bend;
  private final float curve;
  private final int columns;
  private final int rows;

  /** Whether the corner sees plain things only, as far as rays can tell. */
  private final boolean[] plain;

  /** Whether none of those has highlights. */
  private final boolean[] dull;

  /** By which mirrors. */
  private final long[] mirrors;

  /** Whether a square is calm, by its upper left corner. */
  private final boolean[] calm;

  CalmCorners(Prepared scene, CornerGrid corners, LevelScale scale, double levels) {
    this.scene = scene;
    this.corners = corners;
    this.scale = scale;
    bend = (float) (BEND * levels);
    curve = (float) (CURVE * Math.sqrt(levels));
    columns = corners.stride / STEP + 1;
    rows = corners.rows / STEP + 1;
    plain = new boolean[columns * rows];
    dull = new boolean[columns * rows];
    mirrors = new long[columns * rows];
    calm = new boolean[columns * rows];
  }

  /** Returns whether a corner is one of those that all others are told from. */
  static boolean isFirst(int x, int y) {
    return x % STEP == 0 && y % STEP == 0;
  }

  /** Traces a corner from which others are told. */
  void trace(Probe probe, int x, int y) {
    if (corners.signature.length < LEAST) {
      corners.trace(probe, scale, x, y);
      return;
    }
    probe.watchSight(true);
    corners.trace(probe, scale, x, y);
    probe.watchSight(false);
    int at = y / STEP * columns + x / STEP;
    Sight sight = probe.sight();
    plain[at] = sight.isPlain() && !probe.isRandom();
    dull[at] = sight.isDull();
    mirrors[at] = sight.mirrors();
  }

  /** Finds the corners that are calm. */
  void find(Crew<Refiner> crew) throws InterruptedException {
    if (corners.signature.length < LEAST) {
      return;
    }
    crew.run(rows - 1, (refiner, row) -> findAlike(row));
    Probe probe = crew.workers().get(0).probe;
    long worth = CORNERS_PER_OUTLINE * Marks.outlines(scene);
    Reflections reflections = reflections(probe, worth);
    Marks marks = new Marks(scene, probe.view(), corners, reflections.shownBy(worth));
    Map<Long, Boolean> known = new HashMap<>();
    for (int at = 0; at < calm.length; at++) {
      calm[at] =
          calm[at]
              && known.computeIfAbsent(mirrors[at], key -> reflections.areShownBy(worth, key))
              && !marks.at(at % columns, at / columns);
    }
  }

  /** Finds the squares of a row that are calm, for all that rays tell. */
  private void findAlike(int row) {
    for (int column = 0; STEP * (column + 1) < corners.stride; column++) {
      int at = row * columns + column;
      int a = STEP * (row * corners.stride + column);
      int c = a + STEP * corners.stride;
      calm[at] =
          plain[at]
              && plain[at + 1]
              && plain[at + columns]
              && plain[at + columns + 1]
              && STEP * (row + 1) < corners.rows
              && corners.areAlike(a, a + STEP)
              && corners.areAlike(a, c)
              && corners.areAlike(a, c + STEP);
    }
  }

  /** Finds what mirrors show, by one ray for all corners that look into the same. */
  private Reflections reflections(Probe probe, long worth) {
    Map<Long, int[]> counts = new LinkedHashMap<>();
    for (int at = 0; at < calm.length; at++) {
      if (calm[at]) {
        int first = at;
        counts.computeIfAbsent(mirrors[at], key -> new int[] {first, 0})[1]++;
      }
    }
    Reflections reflections = new Reflections();
    for (int[] each : counts.values()) {
      if (each[1] >= worth / PARTS) {
        probe.watchSight(true);
        probe.trace(STEP * (each[0] % columns), STEP * (each[0] / columns));
        probe.watchSight(false);
        reflections.add(probe.sight(), each[1]);
      }
    }
    return reflections;
  }

  /** Fills a corner in if it can be told from those traced; returns whether it can. */
  boolean fill(int x, int y) {
    int right = x % STEP;
    int down = y % STEP;
    int square = y / STEP * columns + x / STEP;
    if (!calm[square]
        || (right == 0 && (x == 0 || !calm[square - 1]))
        || (down == 0 && (y == 0 || !calm[square - columns]))) {
      return false;
    }
    int at = y * corners.stride + x;
    int step = down * corners.stride + right;
    int left = x - 3 * right;
    int top = y - 3 * down;
    boolean before = left >= 0 && top >= 0 && corners.areAlike(at - step, at - 3 * step);
    boolean after =
        x + 3 * right < corners.stride
            && y + 3 * down < corners.rows
            && corners.areAlike(at + step, at + 3 * step);
    boolean even =
        (before || after)
            && corners.isEven(at, step, before, after, bend, dull[square] ? curve : bend);
    if (even) {
      corners.fill(at, step, before, after);
    }
    return even;
  }
}
