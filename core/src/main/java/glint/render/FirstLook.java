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

  FirstLook(
      SmallThings small,
      Film film,
      CornerGrid corners,
      LevelScale scale,
      Crew<Refiner> crew,
      Tiles tiles,
      TileCount done) {
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
    new CornerPass(film, corners, scale, tiles, done).run(crew);
    crew.run(film.height, (refiner, y) -> refiner.survey.classify(y));
    aim();
    do {
      crew.run(film.height, (refiner, y) -> refiner.survey.count(y));
    } while (check());
  }

  /** Looks for things that are too small or thin for the rays through corners. */
  private void aim() throws InterruptedException {
    Map<Integer, List<SmallThings.Glimpse>> glimpses = small.find();
    List<Integer> pixels = List.copyOf(glimpses.keySet());
    Focus[] seen = new Focus[pixels.size()];
    crew.runInBatches(
        seen.length,
        (refiner, i) -> {
          int pixel = pixels.get(i);
          seen[i] = refiner.aim.look(pixel % film.width, pixel / film.width, glimpses.get(pixel));
        });
    for (int i = 0; i < seen.length; i++) {
      if (seen[i] != null) {
        film.aim(pixels.get(i), seen[i]);
      }
    }
  }

  /** Looks into the middle of pixels at edges; returns whether that has found anything. */
  private boolean check() throws InterruptedException {
    boolean[] surprising = new boolean[film.kind.length];
    crew.run(
        tiles.count(),
        (refiner, i) -> {
          done.begin(i);
          tiles.forEach(
              i, (x, y) -> surprising[y * film.width + x] = refiner.survey.surprises(x, y));
        });
    boolean any = false;
    for (int pixel = 0; pixel < surprising.length; pixel++) {
      if (surprising[pixel]) {
        film.kind[pixel] = Film.BUSY;
        any = true;
      }
    }
    return any;
  }
}
