package glint.render;

import glint.image.Image;
import glint.scene.Prepared;
import glint.trace.RayCounts;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ThreadFactory;
import java.util.function.BooleanSupplier;

/** Takes the same number of samples of every pixel, tile by tile. */
final class UniformRender implements Method {

  private final Prepared scene;
  private final RenderSettings settings;
  private final Image image;
  private final Map<Aov, Image> aovs;

  UniformRender(Prepared scene, RenderSettings settings, Image image, Map<Aov, Image> aovs) {
    this.scene = scene;
    this.settings = settings;
    this.image = image;
    this.aovs = aovs;
  }

  @Override
  public Traced run(Progress progress, BooleanSupplier cancelled, ThreadFactory threads)
      throws InterruptedException {
    Tiles tiles = new Tiles(settings);
    double[] cut = new double[settings.width() * settings.height()];
    Settling settling =
        new Settling(
            settings.samples(), image, scene.scene().transfer(), aovs.containsKey(Aov.ERROR));
    List<Worker> workers = new ArrayList<>();
    for (int i = 0; i < Math.min(settings.threads(), tiles.count()); i++) {
      workers.add(
          new Worker(scene, settings, image, cut, settling, new Looker(scene, aovs), cancelled));
    }
    TileCount done = new TileCount(progress, tiles);
    try (Crew<Worker> crew = new Crew<>(workers, cancelled, threads)) {
      crew.run(
          tiles.count(),
          (worker, i) -> {
            done.begin(i);
            tiles.forEach(i, worker::pixel);
            done.add(worker.probe());
          });
    }
    RayCounts rays = new RayCounts();
    long invalid = 0;
    int invalidPixel = Integer.MAX_VALUE;
    for (Worker worker : workers) {
      rays.add(worker.probe().counts());
      invalid += worker.probe().invalid();
      invalidPixel = Math.min(invalidPixel, worker.probe().invalidPixel());
    }
    int n = settings.samples();
    settling.conclude();
    look(settling);
    return new Traced(rays, n, n, n, invalid, invalidPixel, cut, settling.error());
  }

  /** Fills the pictures of the render itself. */
  private void look(Settling settling) {
    Image errors = aovs.get(Aov.ERROR);
    Image counts = aovs.get(Aov.SAMPLES);
    for (int y = 0; y < settings.height(); y++) {
      for (int x = 0; x < settings.width(); x++) {
        if (errors != null) {
          double e = settling.error(x, y);
          errors.set(x, y, e, e, e);
        }
        if (counts != null) {
          double n = settings.samples();
          counts.set(x, y, n, n, n);
        }
      }
    }
  }
}
