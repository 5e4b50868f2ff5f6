package glint.render;

import java.util.List;

/** Tells a listener of finished tiles and rounds, one at a time. */
final class TileCount {

  private final Progress progress;
  private final int total;
  private int done;
  private long rays;

  TileCount(Progress progress, int total) {
    this.progress = progress;
    this.total = total;
  }

  /** A tile is finished, by the thread that owns a probe. */
  synchronized void add(Probe probe) {
    done++;
    rays += probe.newRays();
    progress.tileDone(done, total, rays);
  }

  /** The image is whole, by the work of all threads; each has a refiner of its own. */
  synchronized void whole(List<Refiner> refiners, double error) {
    for (Refiner refiner : refiners) {
      rays += refiner.probe.newRays();
    }
    progress.pictureImproved(error, rays);
  }
}
