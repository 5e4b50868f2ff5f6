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
 * <p>A corner is calm if it and its eight neighbours met the same, their levels run evenly, and no
 * {@link Marks} are there. What lies in the middle of two calm ones is filled in.
 */
final class CalmCorners {

  /** Every so many columns and rows there is a corner from which others are told. */
  static final int STEP = Marks.STEP;

  /**
   * Second differences between calm corners are at most this share of the error accepted, so that
   * what lies between is an eighth of that off a straight line. What is filled in follows a cubic,
   * which leaves a small part of it; {@link Bends} finds the same bends in it as between all
   * corners.
   */
  private static final double BEND = 0.4;

  /** Projections are as dear as a few rays: more than one for so many corners do not pay. */
  private static final int CORNERS_PER_OUTLINE = 24;

  /** In images with fewer corners so little is plain that it is not worth looking for it. */
  private static final int LEAST = 1 << 16;

  /** The same is seen in a mirror made of more parts as if it were not there. */
  private static final int PARTS = 16;

  private final Prepared scene;
  private final CornerGrid corners;
  private final LevelScale scale;
  private final float bend;
  private final int columns;
  private final int rows;

  /** Whether the corner sees plain things only, as far as rays can tell. */
  private final boolean[] plain;

  /** By which mirrors. */
  private final long[] mirrors;

  private final boolean[] calm;

  CalmCorners(Prepared scene, CornerGrid corners, LevelScale scale, double levels) {
    this.scene = scene;
    this.corners = corners;
    this.scale = scale;
    bend = (float) (BEND * levels);
    columns = corners.stride / STEP + 1;
    rows = corners.rows / STEP + 1;
    plain = new boolean[columns * rows];
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
    mirrors[at] = sight.mirrors();
  }

  /** Finds the corners that are calm. */
  void find(Crew<Refiner> crew) throws InterruptedException {
    if (corners.signature.length < LEAST) {
      return;
    }
    crew.run(rows, (refiner, row) -> findEven(row));
    Probe probe = crew.workers().get(0).probe;
    long worth = CORNERS_PER_OUTLINE * Marks.outlines(scene);
    Reflections reflections = reflections(probe, worth);
    Marks marks = new Marks(scene, probe.view(), corners, reflections.shownBy(worth));
    Map<Long, Boolean> known = new HashMap<>();
    for (int at = 0; at < calm.length; at++) {
      calm[at] =
          calm[at]
              && known.computeIfAbsent(mirrors[at], key -> reflections.areShownBy(worth, key))
              && !marks.at(at);
    }
  }

  /** Finds those that are calm, for all that rays tell. */
  private void findEven(int row) {
    int y = STEP * row;
    if (y < STEP || y + STEP >= corners.rows) {
      return;
    }
    for (int x = STEP; x + STEP < corners.stride; x += STEP) {
      int at = row * columns + x / STEP;
      calm[at] =
          plain[at]
              && corners.isAlike(y * corners.stride + x, STEP)
              && corners.isEven(y * corners.stride + x, STEP, bend);
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
    int before = y / STEP * columns + x / STEP;
    if (!calm[before] || !calm[before + down * columns + right]) {
      return false;
    }
    corners.fill(y * corners.stride + x, down * corners.stride + right);
    return true;
  }
}
