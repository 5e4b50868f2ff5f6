package glint.render;

/** Traces all corners: first some of them, for a coarse picture, then tile by tile the others. */
final class CornerPass {

  /** The first picture has a ray for every block of so many pixels, across and down. */
  private static final int COARSE = 8;

  private final Film film;
  private final CornerGrid corners;
  private final LevelScale scale;
  private final Tiles tiles;
  private final TileCount done;

  CornerPass(Film film, CornerGrid corners, LevelScale scale, Tiles tiles, TileCount done) {
    this.film = film;
    this.corners = corners;
    this.scale = scale;
    this.tiles = tiles;
    this.done = done;
  }

  void run(Crew<Refiner> crew) throws InterruptedException {
    int across = (film.width - 1) / COARSE + 1;
    int down = (film.height - 1) / COARSE + 1;
    crew.run(
        down,
        (refiner, row) -> {
          for (int column = 0; column < across; column++) {
            traceCoarse(refiner, COARSE * column, COARSE * row);
          }
        });
    done.whole(crew.workers(), Double.POSITIVE_INFINITY);
    crew.run(
        tiles.count(),
        (refiner, i) -> {
          done.begin(i);
          traceTile(refiner, i);
          done.add(refiner.probe);
        });
  }

  /** Traces a corner ahead of the others, and shows it in all of its block. */
  private void traceCoarse(Refiner refiner, int x, int y) {
    corners.trace(refiner.probe, scale, x, y);
    for (int row = y; row < Math.min(y + COARSE, film.height); row++) {
      for (int column = x; column < Math.min(x + COARSE, film.width); column++) {
        corners.show(x, y, film.image, column, row);
      }
    }
  }

  private void traceTile(Refiner refiner, int tile) {
    int x1 = tiles.endX(tile);
    int y1 = tiles.endY(tile);
    x1 += x1 == film.width ? 1 : 0;
    y1 += y1 == film.height ? 1 : 0;
    for (int y = tiles.beginY(tile); y < y1; y++) {
      for (int x = tiles.beginX(tile); x < x1; x++) {
        if (x % COARSE != 0 || y % COARSE != 0 || x == film.width || y == film.height) {
          corners.trace(refiner.probe, scale, x, y);
        }
        if (x < film.width && y < film.height) {
          corners.show(x, y, film.image, x, y);
        }
      }
    }
  }
}
