package glint.render;

import java.util.List;
import java.util.Map;

/**
 * What is found out of an image before any pixel is refined: what the corners of its pixels see,
 * where things are that are too small for them, and whether the middles of pixels agree.
 */
final class FirstLook {

  private final SmallThings small;
  private final Film film;
  private final CornerGrid corners;
  private final LevelScale scale;
  private final Crew<Refiner> crew;
  private final Tiles tiles;
  private final TileCount done;
  private final CalmCorners calm;

  FirstLook(
      SmallThings small,
      Film film,
      CornerGrid corners,
      LevelScale scale,
      Crew<Refiner> crew,
      Tiles tiles,
      TileCount done,
      CalmCorners calm) {
    this.calm = calm;
    this.small = small;
    this.film = film;
    this.corners = corners;
    this.scale = scale;
    this.crew = crew;
    this.tiles = tiles;
    this.done = done;
  }

  /** Looks at all pixels. */
  void run() throws InterruptedException {
    new CornerPass(film, corners, scale, tiles, done, calm).run(crew);
    crew.run(film.height, (refiner, y) -> refiner.survey.classify(y));
    aim();
    crew.run(film.height, (refiner, y) -> refiner.survey.count(y, 0, film.width));
    check();
  }

  /** Looks for things that are too small or thin for the rays through corners. */
  private void aim() throws InterruptedException {
    Map<Integer, List<Glimpses.Glimpse>> glimpses = small.find();
    List<Integer> pixels = List.copyOf(glimpses.keySet());
    Focus[] seen = new Focus[pixels.size()];
    crew.runInBatches(
        seen.length,
        (refiner, i) -> {
          int pixel = pixels.get(i);
          boolean busy = film.kind[pixel] == Film.BUSY && !film.random[pixel];
          double around = busy || film.veiled[pixel] ? film.contrast[pixel] : 0;
          int x = pixel % film.width;
          int y = pixel / film.width;
          seen[i] = refiner.aim.look(x, y, glimpses.get(pixel), around);
        });
    for (int i = 0; i < seen.length; i++) {
      if (seen[i] != null) {
        film.aim(pixels.get(i), seen[i]);
      }
    }
  }

  /**
   * Looks into the middle of pixels that edges cross or crowd around, and around those where that
   * has found anything.
   */
  private void check() throws InterruptedException {
    Selection found = new Selection();
    crew.run(
        tiles.count(),
        (refiner, i) -> {
          done.begin(i);
          tiles.forEach(i, (x, y) -> check(refiner, y * film.width + x, found));
        });
    while (!found.isEmpty()) {
      int[] due = around(found.take());
      crew.runInBatches(due.length, (refiner, i) -> check(refiner, due[i], found));
    }
  }

  private static void check(Refiner refiner, int pixel, Selection found) {
    if (refiner.survey.surprises(pixel)) {
      synchronized (found) {
        found.add(pixel);
      }
    }
  }

  /** Counts anew the edges around pixels that are not what they were; returns those pixels. */
  private int[] around(int[] pixels) {
    Selection around = new Selection();
    for (int pixel : pixels) {
      int x = pixel % film.width;
      int y = pixel / film.width;
      int left = Math.max(0, x - 1);
      int end = Math.min(film.width, x + 2);
      for (int row = Math.max(0, y - 1); row <= Math.min(film.height - 1, y + 1); row++) {
        crew.workers().get(0).survey.count(row, left, end);
        for (int column = left; column < end; column++) {
          around.add(row * film.width + column);
        }
      }
    }
    return around.take();
  }
}
