package glint.render;

/** Finds out what kinds of pixels a film has; one per thread. */
final class Survey {

  /** A contrast, in levels², that is seen. */
  private static final double VISIBLE = 1;

  private final Film film;
  private final CornerGrid corners;
  private final Probe probe;
  private final double[] scratch;

  Survey(Film film, CornerGrid corners, Probe probe) {
    this.film = film;
    this.corners = corners;
    this.probe = probe;
    scratch = new double[6 * corners.stride];
  }

  /** Decides what kind the pixels of a row are by their corners. */
  void classify(int y) {
    corners.contrasts(y, scratch, film.contrast);
    for (int x = 0; x < film.width; x++) {
      classify(x, y);
    }
  }

  private void classify(int x, int y) {
    long[] met = corners.signature;
    int a = y * corners.stride + x;
    int c = a + corners.stride;
    int crossings = 0;
    crossings += met[a] != met[a + 1] ? 1 : 0;
    crossings += met[c] != met[c + 1] ? 1 : 0;
    crossings += met[a] != met[c] ? 1 : 0;
    crossings += met[a + 1] != met[c + 1] ? 1 : 0;
    int pixel = y * film.width + x;
    film.kind[pixel] = crossings == 0 ? Film.SMOOTH : crossings == 2 ? Film.SPLIT : Film.BUSY;
    // Of an image that shows no contrast, audits tell whether there is none.
    boolean detailed = film.contrast[pixel] > VISIBLE && corners.leapsOverDetail(x, y);
    film.random[pixel] = corners.isRandom(x, y);
    if (detailed || film.random[pixel]) {
      film.kind[pixel] = Film.BUSY;
    }
  }

  /** Counts the edges around a pixel. */
  void count(int x, int y) {
    int busy = 0;
    int splits = 0;
    for (int row = Math.max(0, y - 1); row <= Math.min(film.height - 1, y + 1); row++) {
      for (int column = Math.max(0, x - 1); column <= Math.min(film.width - 1, x + 1); column++) {
        byte kind = film.kind[row * film.width + column];
        busy += kind == Film.BUSY ? 1 : 0;
        splits += kind == Film.SPLIT ? 1 : 0;
      }
    }
    int pixel = y * film.width + x;
    splits -= film.kind[pixel] == Film.SPLIT ? 1 : 0;
    film.surroundings[pixel] = (byte) (4 * grade(busy) + grade(splits));
  }

  /**
   * Looks into the middle of a pixel that is split or beside an edge.
   *
   * @return whether something is there that no corner shows: then nothing is taken for known
   */
  boolean surprises(int x, int y) {
    int pixel = y * film.width + x;
    boolean idle = film.kind[pixel] == Film.SMOOTH && film.surroundings[pixel] == 0;
    if (film.checked[pixel] || film.kind[pixel] == Film.BUSY || idle) {
      return false;
    }
    film.checked[pixel] = true;
    long[] met = corners.signature;
    int a = y * corners.stride + x;
    int c = a + corners.stride;
    boolean finite = probe.trace(x + 0.5, y + 0.5);
    long middle = probe.signature();
    film.middleAsCorner[pixel] = middle == met[a];
    return !finite
        || (middle != met[a] && middle != met[a + 1] && middle != met[c] && middle != met[c + 1]);
  }

  private static int grade(int count) {
    return count == 0 ? 0 : count < 3 ? 1 : count < 5 ? 2 : 3;
  }
}
