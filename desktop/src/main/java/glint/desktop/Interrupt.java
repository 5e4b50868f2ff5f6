package glint.desktop;

import glint.render.Renderer;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Lets a run end in order when a signal (SIGINT, SIGTERM) asks the process to stop.
 *
 * <p>The Java machine then runs the hook below, and afterwards exits with 128 plus the signal's
 * number. The hook stops the renderer and waits while the main thread finishes what it writes,
 * cleans up and closes this object; System.exit in the main thread never returns from there on.
 */
final class Interrupt implements AutoCloseable {

  /**
   * Longer than a tile or the writing of an image takes, and shorter than a service manager's
   * patience.
   */
  private static final long PATIENCE_SECONDS = 10;

  private final CountDownLatch closed = new CountDownLatch(1);
  private final Thread hook = new Thread(this::stop, "glint-interrupt");
  private boolean requested;
  private Renderer renderer;

  private Interrupt() {}

  /** Begins to listen. */
  static Interrupt install() {
    Interrupt interrupt = new Interrupt();
    Runtime.getRuntime().addShutdownHook(interrupt.hook);
    return interrupt;
  }

  /** Returns whether the run shall stop. */
  synchronized boolean requested() {
    return requested;
  }

  /** Makes a renderer the one to be cancelled, at once if the run shall stop already. */
  synchronized void watch(Renderer current) {
    renderer = current;
    if (requested) {
      current.cancel();
    }
  }

  /** Stops the run. */
  synchronized void request() {
    requested = true;
    if (renderer != null) {
      renderer.cancel();
    }
  }

  /** Tells that all is cleaned up, and stops listening. */
  @Override
  public void close() {
    closed.countDown();
    if (!requested()) {
      try {
        Runtime.getRuntime().removeShutdownHook(hook);
      } catch (IllegalStateException e) {
        // The signal came just now, when nothing is left to stop.
        return;
      }
    }
  }

  private void stop() {
    request();
    try {
      if (!closed.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        AtomicFile.deleteUnfinished();
      }
    } catch (InterruptedException e) {
      AtomicFile.deleteUnfinished();
    }
  }
}
