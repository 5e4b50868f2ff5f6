package glint.render;

/** Hears how far a render has come; called by the workers, one at a time but for {@link #begun}. */
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

  /** So many rays are traced so far, of all kinds; heard now and then while pixels are sampled. */
  default void traced(long rays) {}

  /**
   * The thread that tells begins to work on a part of the image, and has done with the part before;
   * threads do not wait for each other.
   *
   * @param x the first column
   * @param y the first row
   * @param endX the column behind the last
   * @param endY the row behind the last
   */
  default void begun(int x, int y, int endX, int endY) {}
}
