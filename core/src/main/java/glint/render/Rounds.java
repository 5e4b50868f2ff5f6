package glint.render;

import java.util.List;
import java.util.Map;

/**
 * Refines an image until its estimated error is as small as was asked for.
 *
 * <p>First a ray through every pixel's corner. Then rounds: what all pixels know now decides what
 * is done next, so that neither threads nor tiles matter.
 */
final class Rounds {

  /** By how much the true error may be above the estimates of the model; found on many scenes. */
  private static final double CALIBRATION = 1.25;

  /** Rounds after which the models are audited at the latest. */
  private static final int EARLY_ROUNDS = 4;

  /** Audits of an image: what is learned at first may no longer hold at the end. */
  private static final int AUDITS = 2;

  /** The most samples of a pixel, as a power of two. */
  private static final int MOST = 20;

  /** By how much a round brings the error down at most where the time is limited. */
  private static final double SHORT_ROUND = 0.7;

  /** Sides that a thread works on in one go. */
  private static final int BATCH = 64;

  private final Film film;
  private final CornerGrid corners;
  private final Sides sides;
  private final LevelScale scale;
  private final ErrorModel model;
  private final Allocation allocation;
  private final Sampling sampling;
  private final Audit audit;
  private final Crew<Refiner> crew;
  private final Tiles tiles;
  private final TileCount done;
  private final SmallThings small;

  Rounds(
      SmallThings small,
      RenderSettings settings,
      Film film,
      CornerGrid corners,
      Sides sides,
      LevelScale scale,
      Crew<Refiner> crew,
      Progress progress) {
    this.small = small;
    this.film = film;
    this.corners = corners;
    this.sides = sides;
    this.scale = scale;
    this.crew = crew;
    model = new ErrorModel(film);
    allocation = new Allocation(film, model);
    tiles = new Tiles(settings);
    done = new TileCount(progress, tiles);
    sampling = new Sampling(film, model, crew, done);
    audit = new Audit(film, model, scale, sampling, settings.seed());
  }

  /**
   * Renders.
   *
   * @param levels the error to come down to
   * @param deadline in the time of {@link System#nanoTime}, when to stop anyway
   * @return the estimate of the sampling error, in levels
   */
  double run(double levels, long deadline) throws InterruptedException {
    begin();
    sampleBusy();
    int audits = 0;
    for (int round = 0; ; round++) {
      sides.learn();
      estimate(round == 0);
      model.learn();
      double error = error(allocation.total());
      done.whole(crew.workers(), error);
      boolean reached = error <= levels;
      if (audits < AUDITS && (reached || (audits == 0 && round == EARLY_ROUNDS))) {
        audit.run(audits++);
        continue;
      }
      boolean late = deadline != Long.MAX_VALUE && System.nanoTime() - deadline > 0;
      double next = deadline == Long.MAX_VALUE ? levels : Math.max(levels, SHORT_ROUND * error);
      allocation.aim(variance(next));
      if (reached || late || !refine()) {
        return error;
      }
    }
  }

  /** Returns the error that is claimed for a variance of all pixels together. */
  private double error(double variance) {
    return CALIBRATION * Math.sqrt(variance / film.kind.length);
  }

  private double variance(double error) {
    return error / CALIBRATION * (error / CALIBRATION) * film.kind.length;
  }

  /** Returns the error that is claimed for a pixel, in levels. */
  double error(int pixel) {
    return CALIBRATION * Math.sqrt(model.variance(pixel));
  }

  private void begin() throws InterruptedException {
    new CornerPass(film, corners, scale, tiles, done).run(crew);
    crew.run(tiles.count(), (refiner, i) -> tiles.forEach(i, refiner::classify));
    aim();
    do {
      crew.run(tiles.count(), (refiner, i) -> tiles.forEach(i, refiner::survey));
    } while (check());
  }

  /** Looks for things that are too small or thin for the rays through corners. */
  private void aim() throws InterruptedException {
    Map<Integer, List<SmallThings.Glimpse>> glimpses = small.find();
    List<Integer> pixels = List.copyOf(glimpses.keySet());
    Focus[] seen = new Focus[pixels.size()];
    crew.run(
        (seen.length + BATCH - 1) / BATCH,
        (refiner, batch) -> {
          for (int i = BATCH * batch; i < Math.min(seen.length, BATCH * (batch + 1)); i++) {
            int pixel = pixels.get(i);
            seen[i] = refiner.aim.look(pixel % film.width, pixel / film.width, glimpses.get(pixel));
          }
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
          tiles.forEach(i, (x, y) -> surprising[y * film.width + x] = refiner.surprises(x, y));
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

  /**
   * Samples pixels of which nothing is known: what their corners show may be all alike by chance.
   */
  private void sampleBusy() throws InterruptedException {
    for (int pixel = 0; pixel < film.kind.length; pixel++) {
      boolean known = film.focus.containsKey(pixel) && !film.random[pixel];
      if (film.kind[pixel] == Film.BUSY && !known) {
        sampling.choose(pixel);
      }
    }
    sampling.run(Refiner.FIRST);
  }

  /** Estimates pixels without samples; smooth ones, which do not change, only at first. */
  private void estimate(boolean first) throws InterruptedException {
    crew.run(
        tiles.count(),
        (refiner, i) ->
            tiles.forEach(
                i,
                (x, y) -> {
                  int pixel = y * film.width + x;
                  boolean changes = first || film.kind[pixel] != Film.SMOOTH;
                  if (film.level[pixel] > 0 && film.random[pixel]) {
                    refiner.listen(x, y);
                  } else if (changes && film.level[pixel] == 0) {
                    refiner.estimate(x, y);
                  }
                }));
  }

  /** Does what is worth it; returns whether there was anything. */
  private boolean refine() throws InterruptedException {
    Refiner any = crew.workers().get(0);
    boolean worked = false;
    boolean found = film.foundMoreInSmooth();
    for (int pixel = 0; pixel < film.kind.length; pixel++) {
      boolean worth = allocation.worth(pixel) && film.level[pixel] < MOST;
      if (worth && allocation.searches(pixel)) {
        any.want(pixel % film.width, pixel / film.width);
      } else if (worth || (found && film.mayHideMore(pixel))) {
        sampling.choose(pixel);
      }
      worked |= worth;
    }
    sampling.run(Refiner.FIRST);
    divide();
    return worked;
  }

  /** Divides the brackets of the sides that are wanted. */
  private void divide() throws InterruptedException {
    int[] wanted = sides.wanted();
    crew.run(
        (wanted.length + BATCH - 1) / BATCH,
        (refiner, batch) -> {
          for (int i = BATCH * batch; i < Math.min(wanted.length, BATCH * (batch + 1)); i++) {
            sides.divide(refiner.probe, wanted[i]);
          }
        });
  }
}
