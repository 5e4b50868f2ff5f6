package glint.render;

/**
 * Estimates pixels of a film from models of them, one at a time; one per thread.
 *
 * <p>A pixel begins with a model of itself that its corners give for nothing: radiance that runs
 * evenly from corner to corner, or two plain colours and an arc between.
 */
final class Estimator {

  private final Film film;
  private final CornerGrid corners;
  private final Brackets brackets;
  private final LevelScale scale;
  private final Inlay inlay;
  private final Split split;
  private final Bends bends;
  private final NoiseAround noise;

  Estimator(Film film, CornerGrid corners, Brackets brackets, Inlay inlay, LevelScale scale) {
    this.film = film;
    this.corners = corners;
    this.brackets = brackets;
    this.inlay = inlay;
    this.scale = scale;
    split = new Split(corners, brackets);
    bends = new Bends(corners, scale);
    noise = new NoiseAround(film, corners, scale);
  }

  /** Estimates all pixels of a row, like {@link #estimate}. */
  void estimateRow(int y) {
    bends.turn(y);
    for (int x = 0; x < film.width; x++) {
      estimate(x, y);
    }
  }

  /**
   * Takes a pixel that was never sampled from its model, and estimates the error of that; of one
   * whose samples are random, what is around.
   */
  void estimate(int x, int y) {
    int pixel = y * film.width + x;
    if (film.level[pixel] > 0) {
      if (film.random[pixel]) {
        noise.listen(x, y);
      }
    } else if (film.kind[pixel] == Film.SMOOTH && film.inlaid[pixel]) {
      inlay.look(x, y, 1);
      film.image.set(x, y, inlay.mean[0], inlay.mean[1], inlay.mean[2]);
      film.own[pixel] = (float) inlay.variance;
    } else if (film.kind[pixel] == Film.SMOOTH) {
      showCorners(x, y);
      film.own[pixel] = (float) bends.error(x, y, film.image);
    } else if (film.kind[pixel] == Film.BUSY || !showParts(x, y)) {
      film.kind[pixel] = Film.BUSY;
      showBusy(x, y);
    }
  }

  private void showCorners(int x, int y) {
    film.image.set(x, y, corners.mean(x, y, 0), corners.mean(x, y, 1), corners.mean(x, y, 2));
  }

  /** Takes a split pixel from its two parts; returns whether they are what is in it. */
  private boolean showParts(int x, int y) {
    int pixel = y * film.width + x;
    boolean inside = film.insideAsCorner[pixel];
    if (!split.look(x, y, inside) || !split.agrees(inside)) {
      return false;
    }
    film.image.set(x, y, split.mean(0), split.mean(1), split.mean(2));
    film.doubt[pixel] = (float) (split.doubt(scale) + bends.error(x, y, film.image));
    film.own[pixel] = (float) split.variance(scale) + film.doubt[pixel];
    return true;
  }

  private void showBusy(int x, int y) {
    int pixel = y * film.width + x;
    Focus focus = film.focus[pixel];
    if (focus != null) {
      film.image.set(x, y, focus.guess[0], focus.guess[1], focus.guess[2]);
      film.own[pixel] = (float) focus.unseen();
    } else {
      showCorners(x, y);
      film.own[pixel] = 0.3f * film.contrast[pixel];
    }
  }

  /** Returns whether the edge of a split pixel may, for all that is known, run along corners. */
  boolean mayRunAlongCorners(int x, int y) {
    split.cross(x, y);
    return brackets.endsAtCorner(split.crossed(0), 2) && brackets.endsAtCorner(split.crossed(1), 2);
  }

  /** Asks for the brackets of a split pixel to be divided, once or twice. */
  void want(int x, int y, boolean twice) {
    if (split.cross(x, y)) {
      int steps = split.steps();
      int one = split.crossed(0);
      int two = split.crossed(1);
      boolean both = brackets.endsAtCorner(one, 2) && brackets.endsAtCorner(two, 2);
      for (int i = 0; i < 2; i++) {
        int side = split.crossed(i);
        if (brackets.steps(side) <= steps + 1) {
          brackets.want(side, both || brackets.endsAtCorner(side, 3), twice);
        }
      }
    }
  }
}
