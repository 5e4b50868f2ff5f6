package glint.render;

import java.util.Arrays;

/** Samples chosen pixels, on all threads. */
final class Sampling {

  /** Pixels that a thread works on in one go. */
  private static final int BATCH = 64;

  private final Film film;
  private final ErrorModel model;
  private final Crew<Refiner> crew;
  private final TileCount done;
  private final boolean[] isChosen;
  private int[] chosen = new int[1024];
  private int count;

  Sampling(Film film, ErrorModel model, Crew<Refiner> crew, TileCount done) {
    this.film = film;
    this.model = model;
    this.crew = crew;
    this.done = done;
    isChosen = new boolean[film.kind.length];
  }

  /** Chooses a pixel for the next run, if it is not chosen yet. */
  void choose(int pixel) {
    if (isChosen[pixel]) {
      return;
    }
    isChosen[pixel] = true;
    if (count == chosen.length) {
      chosen = Arrays.copyOf(chosen, 2 * count);
    }
    chosen[count++] = pixel;
    film.open(pixel);
  }

  /** Returns whether any pixel is chosen. */
  boolean hasChosen() {
    return count > 0;
  }

  /** Returns the pixels that are chosen. */
  int[] chosen() {
    return Arrays.copyOf(chosen, count);
  }

  /**
   * Doubles the samples of the pixels chosen, and begins to choose anew.
   *
   * @param least as a power of two, the samples that a pixel shall have at least
   */
  void run(int least) throws InterruptedException {
    double[] moved = new double[count];
    crew.run(
        (count + BATCH - 1) / BATCH,
        (refiner, batch) -> {
          int end = Math.min(count, BATCH * (batch + 1));
          done.begin(chosen[BATCH * batch], chosen[end - 1]);
          for (int i = BATCH * batch; i < end; i++) {
            int first = film.focus.containsKey(chosen[i]) ? Refiner.FIRST + 1 : least;
            int level = Math.max(first, film.level[chosen[i]] + 1);
            moved[i] = refiner.sample(chosen[i] % film.width, chosen[i] / film.width, level);
          }
          done.count(refiner.probe);
        });
    for (int i = 0; i < count; i++) {
      int x = chosen[i] % film.width;
      int y = chosen[i] / film.width;
      film.compare(x, y);
      if (film.random[chosen[i]]) {
        crew.workers().get(0).listen(x, y);
      }
      model.note(chosen[i], moved[i]);
      isChosen[chosen[i]] = false;
    }
    count = 0;
  }
}
