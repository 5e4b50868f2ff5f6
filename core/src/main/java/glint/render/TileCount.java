package glint.render;

import java.util.List;

/** Tells a listener of what is begun and, one at a time, of finished tiles and rounds. */
final class TileCount {

  private final Progress progress;
  private final Tiles tiles;
  private int done;
  private long rays;

  TileCount(Progress progress, Tiles tiles) {
    this.progress = progress;
    this.tiles = tiles;
  }

  /** This thread begins with a tile. */
  void begin(int tile) {
    progress.begun(tiles.beginX(tile), tiles.beginY(tile), tiles.endX(tile), tiles.endY(tile));
  }

  /** This thread begins with pixels from a first one to a last one, row by row. */
  void begin(int first, int last) {
    int width = tiles.width();
    boolean one = first / width == last / width;
    int x = one ? first % width : 0;
    progress.begun(x, first / width, one ? last % width + 1 : width, last / width + 1);
  }

  /** Something else than a tile is finished, by the thread that owns a probe. */
  synchronized void count(Probe probe) {
    rays += probe.newRays();
    progress.traced(rays);
  }

  /** A tile is finished, by the thread that owns a probe. */
  synchronized void add(Probe probe) {
    done++;
    rays += probe.newRays();
    progress.tileDone(done, tiles.count(), rays);
  }

  /** The image is whole, by the work of all threads; each has a refiner of its own. */
  synchronized void whole(List<Refiner> refiners, double error) {
    for (Refiner refiner : refiners) {
      rays += refiner.probe.newRays();
    }
    progress.pictureImproved(error, rays);
  }
}
