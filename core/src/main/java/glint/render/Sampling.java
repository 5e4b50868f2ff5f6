package glint.render;

import java.util.Arrays;

/** Samples chosen pixels, on all threads. */
final class Sampling {

  /** Pixels that a thread works on in one go. */
  private static final int BATCH = 64;

  /** In images of fewer pixels than so many, those that are sampled take more samples at first. */
  private static final int SMALL = 1 << 10;

  private final Film film;
  private final ErrorModel model;
  private final Crew<Refiner> crew;
  private final TileCount done;

  /** The first samples of a pixel, as a power of two. */
  private final int first;

  private final boolean[] isChosen;
  private int[] chosen = new int[1024];
  private int count;

  Sampling(Film film, ErrorModel model, Crew<Refiner> crew, TileCount done) {
    this.film = film;
    this.model = model;
    this.crew = crew;
    this.done = done;
    int pixels = film.kind.length;
    int doublings = Integer.numberOfLeadingZeros(pixels) - Integer.numberOfLeadingZeros(SMALL);
    first = Refiner.FIRST + Math.max(0, doublings);
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

  /** Doubles the samples of the pixels chosen, and begins to choose anew. */
  void run() throws InterruptedException {
    run(first);
  }

  /**
   * Does the same.
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
            int begin = film.focus.containsKey(chosen[i]) ? first + 1 : Math.max(first, least);
            int level = Math.max(begin, film.level[chosen[i]] + 1);
            moved[i] = refiner.sample(chosen[i] % film.width, chosen[i] / film.width, level);
          }
          done.count(refiner.probe);
        });
    for (int i = 0; i < count; i++) {
      int x = chosen[i] % film.width;
      int y = chosen[i] / film.width;
      film.compare(x, y);
      film.outdateAround(x, y);
      if (film.random[chosen[i]]) {
        crew.workers().get(0).noise.listen(x, y);
      }
      model.note(chosen[i], moved[i]);
      isChosen[chosen[i]] = false;
    }
    count = 0;
  }
}
