package glint.render;

import glint.image.Image;
import glint.scene.Prepared;
import glint.trace.RayCounts;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/** Takes the same number of samples of every pixel, tile by tile. */
final class UniformRender implements Method {

  private final Prepared scene;
  private final RenderSettings settings;
  private final Image image;
  private final Supplier<Looker> lookers;

  UniformRender(Prepared scene, RenderSettings settings, Image image, Supplier<Looker> lookers) {
    this.scene = scene;
    this.settings = settings;
    this.image = image;
    this.lookers = lookers;
  }

  @Override
  public Traced run(Progress progress, BooleanSupplier cancelled) throws InterruptedException {
    Tiles tiles = new Tiles(settings);
    double[] cut = new double[settings.width() * settings.height()];
    List<Worker> workers = new ArrayList<>();
    for (int i = 0; i < Math.min(settings.threads(), tiles.count()); i++) {
      workers.add(new Worker(scene, settings, image, cut, lookers.get(), cancelled));
    }
    TileCount done = new TileCount(progress, tiles.count());
    try (Crew<Worker> crew = new Crew<>(workers, cancelled)) {
      crew.run(
          tiles.count(),
          (worker, i) -> {
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
    return new Traced(rays, n, n, n, invalid, invalidPixel, cut, Double.NaN);
  }
}
