package glint.render;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ThreadFactory;
import java.util.function.BooleanSupplier;

/** A way to find the pixels of an image. */
interface Method {

  /**
   * Finds them.
   *
   * @param cancelled asked now and then whether to stop
   * @param threads makes those of the workers
   * @throws InterruptedException if the thread was interrupted
   * @throws CancellationException if the render was cancelled
   */
  Traced run(Progress progress, BooleanSupplier cancelled, ThreadFactory threads)
      throws InterruptedException;
}
