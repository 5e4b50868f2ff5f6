package glint.render;

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

  private final Selection chosen = new Selection();

  Sampling(Film film, ErrorModel model, Crew<Refiner> crew, TileCount done) {
    this.film = film;
    this.model = model;
    this.crew = crew;
    this.done = done;
    int pixels = film.kind.length;
    int doublings = Integer.numberOfLeadingZeros(pixels) - Integer.numberOfLeadingZeros(SMALL);
    first = Refiner.FIRST + Math.max(0, doublings);
  }

  /** Chooses a pixel for the next run, if it is not chosen yet. */
  void choose(int pixel) {
    chosen.add(pixel);
  }

  /** Returns whether any pixel is chosen. */
  boolean hasChosen() {
    return !chosen.isEmpty();
  }

  /** Returns the pixels that are chosen. */
  int[] chosen() {
    return chosen.list();
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
    int[] pixels = chosen.take();
    film.open(pixels);
    double[] moved = new double[pixels.length];
    crew.run(
        (pixels.length + BATCH - 1) / BATCH,
        (refiner, batch) -> {
          int end = Math.min(pixels.length, BATCH * (batch + 1));
          done.begin(pixels[BATCH * batch], pixels[end - 1]);
          for (int i = BATCH * batch; i < end; i++) {
            int begin = film.focus[pixels[i]] != null ? first + 1 : Math.max(first, least);
            int level = Math.max(begin, film.level[pixels[i]] + 1);
            moved[i] = refiner.sample(pixels[i] % film.width, pixels[i] / film.width, level);
          }
          done.count(refiner.probe);
        });
    crew.runInBatches(pixels.length, (refiner, i) -> film.compare(pixels[i]));
    for (int i = 0; i < pixels.length; i++) {
      film.outdateAround(pixels[i]);
      model.note(pixels[i], moved[i]);
    }
  }
}
