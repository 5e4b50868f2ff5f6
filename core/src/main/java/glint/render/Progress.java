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

  /**
   * The image shows a whole picture, better than before; heard only of renders to an error, between
   * their rounds, while no worker changes it.
   *
   * @param error what is claimed for it, in levels; infinite for the first, coarse one
   * @param rays rays traced so far, of all kinds
   */
  default void pictureImproved(double error, long rays) {}
}
