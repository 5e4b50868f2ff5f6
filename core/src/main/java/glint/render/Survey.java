package glint.render;

/** Finds out what kinds of pixels a film has; one per thread. */
final class Survey {

  /** A contrast, in levels², that is seen. */
  private static final double VISIBLE = 1;

  /** More than nine pixels. */
  private static final int MANY = 16;

  /** With less around, five split pixels or a busy one, a smooth pixel is what it seems to be. */
  private static final int CROWDED = 3;

  /** What a pixel of each kind counts, so that one sum holds the split ones and the busy ones. */
  private static final int[] EDGES = {0, 1, MANY};

  private final Film film;
  private final CornerGrid corners;
  private final Brackets brackets;
  private final Probe probe;
  private final Inlay inlay;
  private final Contrasts contrasts;

  /** Those if images had one colour all over; null if there are none. */
  private final Contrasts plainContrasts;

  /** What those are of a row. */
  private final float[] plain;

  /** The sum over the up to three pixels of a column; one column more on each side. */
  private final int[] edges;

  Survey(Film film, CornerGrid corners, Brackets brackets, Inlay inlay, Probe probe) {
    this.film = film;
    this.corners = corners;
    this.brackets = brackets;
    this.probe = probe;
    this.inlay = inlay;
    Prints prints = corners.prints;
    contrasts = new Contrasts(corners, corners.levels);
    plainContrasts = prints == null ? null : new Contrasts(corners, prints.plain);
    plain = new float[prints == null ? 0 : film.width];
    edges = new int[film.width + 2];
  }

  /** Decides what kind the pixels of a row are by their corners. */
  void classify(int y) {
    contrasts.find(y, film.contrast, y * film.width);
    if (plainContrasts != null) {
      plainContrasts.find(y, plain, 0);
    }
    for (int x = 0; x < film.width; x++) {
      classify(x, y);
    }
  }

  private void classify(int x, int y) {
    int crossings = corners.crossings(x, y);
    int pixel = y * film.width + x;
    film.kind[pixel] = crossings == 0 ? Film.SMOOTH : crossings == 2 ? Film.SPLIT : Film.BUSY;
    film.random[pixel] = corners.isRandom(x, y);
    boolean even = crossings == 0 && !film.random[pixel];
    film.inlaid[pixel] = even && plain.length > 0 && inlay.suits(x, y);
    if (film.inlaid[pixel]) {
      film.contrast[pixel] = plain[x];
    } else if (film.random[pixel] || isDetailed(x, y)) {
      film.kind[pixel] = Film.BUSY;
    }
    float between = crossings == 0 ? corners.lightBetweenShadows(x, y) : 0;
    if (between > 0) {
      film.veiled[pixel] = film.kind[pixel] == Film.SMOOTH;
      film.contrast[pixel] = Math.max(film.contrast[pixel], between);
    }
  }

  /** Of an image that shows no contrast, audits tell whether there is none. */
  private boolean isDetailed(int x, int y) {
    return film.contrast[y * film.width + x] > VISIBLE && corners.leapsOverDetail(x, y);
  }

  /** Counts the edges around the pixels of a row, from one up to another. */
  void count(int y, int begin, int end) {
    int first = Math.max(0, y - 1) * film.width;
    int last = Math.min(film.height - 1, y + 1) * film.width;
    for (int x = Math.max(0, begin - 1); x < Math.min(film.width, end + 1); x++) {
      edges[x + 1] = 0;
      for (int pixel = first + x; pixel <= last + x; pixel += film.width) {
        edges[x + 1] += EDGES[film.kind[pixel]];
      }
    }
    for (int x = begin; x < end; x++) {
      int pixel = y * film.width + x;
      int own = film.kind[pixel] == Film.SPLIT ? EDGES[Film.SPLIT] : 0;
      int around = edges[x] + edges[x + 1] + edges[x + 2] - own;
      film.surroundings[pixel] =
          (byte) (around == 0 ? 0 : 4 * grade(around / MANY) + grade(around % MANY));
    }
  }

  /**
   * Looks into a pixel that is split or has much around it, near its middle, once.
   *
   * @return whether something is there that no corner shows: then nothing is taken for known
   */
  boolean surprises(int pixel) {
    boolean plain = film.kind[pixel] == Film.SMOOTH && film.surroundings[pixel] < CROWDED;
    if (plain || film.kind[pixel] == Film.BUSY || film.checked[pixel]) {
      return false;
    }
    film.checked[pixel] = true;
    int x = pixel % film.width;
    int y = pixel / film.width;
    long[] met = corners.signature;
    int a = y * corners.stride + x;
    int c = a + corners.stride;
    boolean finite = probe.trace(x + brackets.insideX(x, y), y + brackets.insideY(x, y));
    long inside = probe.signature();
    film.insideAsCorner[pixel] = inside == met[a];
    boolean known =
        inside == met[a] || inside == met[a + 1] || inside == met[c] || inside == met[c + 1];
    if (!finite || !known) {
      film.kind[pixel] = Film.BUSY;
      film.inlaid[pixel] = false;
    }
    return film.kind[pixel] == Film.BUSY;
  }

  private static int grade(int count) {
    return count == 0 ? 0 : count < 3 ? 1 : count < 5 ? 2 : 3;
  }
}
