package glint.render;

/**
 * Traces all corners, but for those that others tell all of: first some of them, for a coarse
 * picture, then tile by tile every second one, and then what is left.
 */
final class CornerPass {

  /** The first picture has a ray for every block of so many pixels, across and down. */
  private static final int COARSE = 8;

  private final Film film;
  private final CornerGrid corners;
  private final LevelScale scale;
  private final Tiles tiles;
  private final TileCount done;
  private final CalmCorners calm;

  CornerPass(
      Film film,
      CornerGrid corners,
      LevelScale scale,
      Tiles tiles,
      TileCount done,
      CalmCorners calm) {
    this.calm = calm;
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
    crew.run(tiles.count(), this::traceFirst);
    calm.find(crew);
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
    calm.trace(refiner.probe, x, y);
    for (int row = y; row < Math.min(y + COARSE, film.height); row++) {
      for (int column = x; column < Math.min(x + COARSE, film.width); column++) {
        corners.show(x, y, film.image, column, row);
      }
    }
  }

  /** Traces the corners of a tile from which others may be told. */
  private void traceFirst(Refiner refiner, int tile) {
    int step = CalmCorners.STEP;
    for (int y = first(tiles.beginY(tile)); y < endY(tile); y += step) {
      for (int x = first(tiles.beginX(tile)); x < endX(tile); x += step) {
        if (x % COARSE != 0 || y % COARSE != 0 || x == film.width || y == film.height) {
          calm.trace(refiner.probe, x, y);
        }
      }
    }
  }

  /** Returns the first number, from one on, of a row or column from which others may be told. */
  private static int first(int from) {
    return from + Math.floorMod(-from, CalmCorners.STEP);
  }

  private void traceTile(Refiner refiner, int tile) {
    int x1 = endX(tile);
    int y1 = endY(tile);
    for (int y = tiles.beginY(tile); y < y1; y++) {
      for (int x = tiles.beginX(tile); x < x1; x++) {
        if (!CalmCorners.isFirst(x, y) && !calm.fill(x, y)) {
          corners.trace(refiner.probe, scale, x, y);
        }
        if (x < film.width && y < film.height) {
          corners.show(x, y, film.image, x, y);
        }
      }
    }
  }

  /** Returns where the corners of a tile end, with those at the end of the image. */
  private int endX(int tile) {
    return tiles.endX(tile) == film.width ? film.width + 1 : tiles.endX(tile);
  }

  private int endY(int tile) {
    return tiles.endY(tile) == film.height ? film.height + 1 : tiles.endY(tile);
  }
}
