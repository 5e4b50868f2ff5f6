package glint.render;

/**
 * Refines an image until its estimated error is as small as was asked for.
 *
 * <p>After a {@link FirstLook} it goes in rounds: what all pixels know now decides what is done
 * next, so that neither threads nor tiles matter.
 */
final class Rounds {

  /** Rounds after which the models are audited at the latest. */
  private static final int EARLY_ROUNDS = 4;

  /** Audits of an image at most: what is learned at first may no longer hold at the end. */
  private static final int AUDITS = 2;

  /**
   * Within so many times the error that is accepted models are audited, so that the rounds left go
   * by what is found; once more where the error falls by as much after that.
   */
  private static final double NEAR = 2;

  /** The most samples of a pixel, as a power of two. */
  private static final int MOST = 20;

  /** By how much a round brings the error down at most where the time is limited. */
  private static final double SHORT_ROUND = 0.7;

  private final Film film;
  private final CornerGrid corners;
  private final FirstLook firstLook;
  private final Brackets brackets;
  private final ErrorModel model;
  private final Allocation allocation;
  private final Sampling sampling;
  private final Audit audit;
  private final Crew<Refiner> crew;
  private final TileCount done;

  Rounds(
      CalmCorners calm,
      SmallThings small,
      RenderSettings settings,
      Film film,
      CornerGrid corners,
      Brackets brackets,
      LevelScale scale,
      Crew<Refiner> crew,
      Progress progress) {
    this.film = film;
    this.corners = corners;
    this.brackets = brackets;
    this.crew = crew;
    Hidden hidden = new Hidden(film);
    model = new ErrorModel(film, hidden);
    allocation = new Allocation(film, model, hidden);
    Tiles tiles = new Tiles(settings);
    done = new TileCount(progress, tiles);
    firstLook = new FirstLook(small, film, corners, scale, crew, tiles, done, calm);
    sampling = new Sampling(film, model, crew, done);
    audit = new Audit(film, model, hidden, scale, sampling, settings.seed());
  }

  /**
   * Renders.
   *
   * @param levels the error to come down to
   * @param deadline in the time of {@link System#nanoTime}, when to stop anyway
   * @return the estimate of the sampling error, in levels
   */
  double run(double levels, long deadline) throws InterruptedException {
    firstLook.run();
    sampleBusy();
    int audits = 0;
    boolean audited = false;
    double nextAudit = Double.POSITIVE_INFINITY;
    for (int round = 0; ; round++) {
      boolean learned = brackets.learn();
      if (round == 0) {
        estimateAll();
      } else {
        estimate(learned);
      }
      model.learn();
      double error = error(allocation.total());
      done.whole(crew.workers(), error);
      boolean reached = error <= levels;
      nextAudit = audited ? error / NEAR : nextAudit;
      audited = false;
      boolean due = error <= NEAR * levels || (audits == 0 && round == EARLY_ROUNDS);
      if (due && error < nextAudit && audits < AUDITS) {
        audit.run(audits++);
        audited = true;
        allocation.wake();
        continue;
      }
      boolean late = deadline != Long.MAX_VALUE && System.nanoTime() - deadline > 0;
      double next = deadline == Long.MAX_VALUE ? levels : Math.max(levels, SHORT_ROUND * error);
      if (reached || late || !refine(next)) {
        return error;
      }
    }
  }

  /** Returns the error that is claimed for a variance of all pixels together. */
  private double error(double variance) {
    return ErrorModel.CALIBRATION * Math.sqrt(variance / film.kind.length);
  }

  private double variance(double error) {
    return error / ErrorModel.CALIBRATION * (error / ErrorModel.CALIBRATION) * film.kind.length;
  }

  /** Returns the error that is claimed for a pixel, in levels. */
  double error(int pixel) {
    return ErrorModel.CALIBRATION * Math.sqrt(model.variance(pixel));
  }

  /**
   * Samples pixels of which nothing is known: what their corners show may be all alike by chance.
   * Of those with several edges, corners tell what colours there are.
   */
  private void sampleBusy() throws InterruptedException {
    for (int pixel = 0; pixel < film.kind.length; pixel++) {
      if (film.kind[pixel] == Film.BUSY && (film.random[pixel] || !isKnown(pixel))) {
        sampling.choose(pixel);
      }
    }
    sampling.run();
  }

  private boolean isKnown(int pixel) {
    int x = pixel % film.width;
    int y = pixel / film.width;
    boolean tellsColours = corners.crossings(x, y) > 2 && !corners.leapsOverDetail(x, y);
    return tellsColours || film.focus[pixel] != null;
  }

  /** Estimates all pixels but those just sampled. */
  private void estimateAll() throws InterruptedException {
    crew.run(film.height, (refiner, y) -> refiner.estimator.estimateRow(y));
  }

  /**
   * Estimates once more those that better knowledge of what is around may have changed.
   *
   * @param corners whether that may be so of edges that run along corners
   */
  private void estimate(boolean corners) throws InterruptedException {
    int[] active = allocation.active();
    crew.runInBatches(
        active.length,
        (refiner, i) -> {
          int pixel = active[i];
          if (film.kind[pixel] == Film.SMOOTH) {
            return;
          }
          int x = pixel % film.width;
          int y = pixel / film.width;
          boolean edge = corners && film.kind[pixel] == Film.SPLIT;
          if (film.stale[pixel] || (edge && refiner.estimator.mayRunAlongCorners(x, y))) {
            film.stale[pixel] = false;
            refiner.estimator.estimate(x, y);
          }
        });
  }

  /** Does what is worth it to come down to an error; returns whether there was anything. */
  private boolean refine(double next) throws InterruptedException {
    allocation.aim(variance(next));
    Estimator any = crew.workers().get(0).estimator;
    allocation.forEachWorthy(
        (pixel, twice) -> {
          if (allocation.searches(pixel)) {
            any.want(pixel % film.width, pixel / film.width, twice);
          } else if (film.level[pixel] < MOST) {
            sampling.choose(pixel);
          }
        });
    chooseHiding();
    int[] wanted = brackets.wanted();
    boolean worked = wanted.length > 0 || sampling.hasChosen();
    sampling.run();
    crew.runInBatches(wanted.length, (refiner, i) -> brackets.divide(refiner.probe, wanted[i]));
    Sides sides = brackets.sides;
    for (int side : wanted) {
      int x = sides.column(side);
      int y = sides.row(side);
      film.outdate(x, y);
      film.outdate(sides.isHorizontal(side) ? x : x - 1, sides.isHorizontal(side) ? y - 1 : y);
    }
    return worked;
  }

  /** Chooses smooth pixels beside those whose samples have found more: they may hide as much. */
  private void chooseHiding() {
    boolean any = false;
    for (int pixel : allocation.active()) {
      if (film.kind[pixel] == Film.SMOOTH && film.foundMore(pixel)) {
        any |= film.forEachUnsampledAround(pixel, sampling::choose);
      }
    }
    if (any) {
      allocation.wake();
    }
  }
}
