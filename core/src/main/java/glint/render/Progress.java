package glint.render;

/** Hears how far a render has come; called by the workers, one at a time. */
public interface Progress {

  /** Ignores everything. */
  Progress NONE = (done, total, rays) -> {};

  /**
   * A tile is finished.
   *
   * @param done tiles finished so far
   * @param total tiles in all
   * @param rays rays traced so far, of all kinds
   */
  void tileDone(int done, int total, long rays);
}
