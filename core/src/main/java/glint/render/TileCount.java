package glint.render;

/** Tells a listener of finished tiles, one at a time. */
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
}
