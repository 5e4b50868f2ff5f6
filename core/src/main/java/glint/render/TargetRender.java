package glint.render;

import glint.image.Image;
import glint.scene.Prepared;
import glint.trace.RayCounts;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ThreadFactory;
import java.util.function.BooleanSupplier;

/** Renders to an error or a time: sets up what the rounds need, and gathers what they have done. */
final class TargetRender implements Method {

  private final Prepared scene;
  private final RenderSettings settings;
  private final Goal.Error goal;
  private final Map<Aov, Image> aovs;
  private final PixelWatch watch;
  private final Film film;
  private final CornerGrid corners;
  private final Brackets brackets;
  private Rounds rounds;

  TargetRender(
      Prepared scene,
      RenderSettings settings,
      Goal.Error goal,
      Image image,
      Map<Aov, Image> aovs,
      PixelWatch watch) {
    this.watch = watch;
    this.scene = scene;
    this.settings = settings;
    this.goal = goal;
    this.aovs = aovs;
    film = new Film(image);
    boolean images = scene.plan().images().used();
    boolean shadows = scene.plan().shadows().used();
    corners = new CornerGrid(image.width(), image.height(), images, shadows);
    brackets = new Brackets(corners, settings.seed());
  }

  @Override
  public Traced run(Progress progress, BooleanSupplier cancelled, ThreadFactory threads)
      throws InterruptedException {
    long deadline = deadline();
    LevelScale scale = LevelScale.of(scene.scene().transfer());
    RenderSettings cutting = settings.following(Cutoff.find(scene, settings, goal.levels(), scale));
    List<Refiner> refiners = new ArrayList<>();
    for (int i = 0; i < settings.threads(); i++) {
      Probe probe = new Probe(scene, cutting, watch);
      refiners.add(new Refiner(film, corners, brackets, scale, probe, goal.levels()));
    }
    try (Crew<Refiner> crew = new Crew<>(refiners, cancelled, threads)) {
      SmallThings small = new SmallThings(scene, refiners.get(0).probe.view(), corners);
      Progress filling = aovs.isEmpty() ? progress : new Filling(progress);
      rounds =
          new Rounds(
              new CalmCorners(scene, corners, scale, goal.levels()),
              small,
              settings,
              film,
              corners,
              brackets,
              scale,
              crew,
              filling);
      double error = rounds.run(goal.levels() * (1 - Cutoff.SHARE), deadline);
      look(crew);
      return traced(refiners, error);
    }
  }

  private long deadline() {
    double nanos = goal.seconds() * 1e9;
    return nanos < 0x1p62 ? System.nanoTime() + (long) nanos : Long.MAX_VALUE;
  }

  private void look(Crew<Refiner> crew) throws InterruptedException {
    if (aovs.isEmpty()) {
      return;
    }
    Tiles tiles = new Tiles(settings);
    crew.run(
        tiles.count(),
        (refiner, i) -> {
          Looker looker = new Looker(scene, aovs);
          tiles.forEach(i, (x, y) -> looker.look(refiner.probe, x, y));
        });
    fill();
  }

  /** Fills the pictures of the render itself. */
  private void fill() {
    Image errors = aovs.get(Aov.ERROR);
    Image samples = aovs.get(Aov.SAMPLES);
    for (int y = 0; y < film.height; y++) {
      for (int x = 0; x < film.width; x++) {
        if (errors != null) {
          double e = rounds.error(y * film.width + x);
          errors.set(x, y, e, e, e);
        }
        if (samples != null) {
          int n = rays(x, y);
          samples.set(x, y, n, n, n);
        }
      }
    }
  }

  /** Fills pictures before others hear of the image. */
  private final class Filling implements Progress {
    private final Progress progress;

    Filling(Progress progress) {
      this.progress = progress;
    }

    @Override
    public void tileDone(int done, int total, long rays) {
      progress.tileDone(done, total, rays);
    }

    @Override
    public void traced(long rays) {
      progress.traced(rays);
    }

    @Override
    public void begun(int x, int y, int endX, int endY) {
      progress.begun(x, y, endX, endY);
    }

    @Override
    public void pictureImproved(double error, long rays) {
      if (error < Double.POSITIVE_INFINITY) {
        fill();
      }
      progress.pictureImproved(error, rays);
    }
  }

  /** Returns how many camera rays a pixel took: of what it shares, those above and to the left. */
  private int rays(int x, int y) {
    int pixel = y * film.width + x;
    int searches = Math.max(0, brackets.steps(brackets.sides.top(x, y)));
    searches += Math.max(0, brackets.steps(brackets.sides.left(x, y)));
    int corner = corners.filledIn[y * corners.stride + x] ? 0 : 1;
    return corner + searches + (film.checked[pixel] ? 1 : 0) + film.samples(pixel);
  }

  private Traced traced(List<Refiner> refiners, double error) {
    RayCounts counts = new RayCounts();
    long invalid = 0;
    int invalidPixel = Integer.MAX_VALUE;
    for (Refiner refiner : refiners) {
      counts.add(refiner.probe.counts());
      invalid += refiner.probe.invalid();
      invalidPixel = Math.min(invalidPixel, refiner.probe.invalidPixel());
    }
    int least = Integer.MAX_VALUE;
    int most = 0;
    long sum = 0;
    double[] cut = new double[film.kind.length];
    for (int y = 0; y < film.height; y++) {
      for (int x = 0; x < film.width; x++) {
        int n = rays(x, y);
        least = Math.min(least, n);
        most = Math.max(most, n);
        sum += n;
        cut[y * film.width + x] = cut(x, y);
      }
    }
    double mean = (double) sum / cut.length;
    return new Traced(counts, least, mean, most, invalid, invalidPixel, cut, error);
  }

  private double cut(int x, int y) {
    int slot = film.slot[y * film.width + x];
    if (slot >= 0 && film.valid[slot] > 0) {
      return film.cut[slot] / film.valid[slot];
    }
    int a = y * corners.stride + x;
    int c = a + corners.stride;
    return 0.25 * (corners.cut[a] + corners.cut[a + 1] + corners.cut[c] + corners.cut[c + 1]);
  }
}
