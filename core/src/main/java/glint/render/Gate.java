package glint.render;

/** Where the workers of a render ask, between two pieces of work, whether to go on; thread-safe. */
final class Gate {

  private volatile boolean shut;
  private volatile boolean held;

  /**
   * Returns whether the render is over; while it is held, waits until it is let go or closed.
   *
   * <p>A thread that is interrupted meanwhile is told that it is over, and stays interrupted.
   */
  boolean closed() {
    return held ? closedAfterWaiting() : shut;
  }

  private synchronized boolean closedAfterWaiting() {
    while (held && !shut) {
      try {
        wait();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return true;
      }
    }
    return shut;
  }

  /** Ends the render. */
  synchronized void close() {
    shut = true;
    notifyAll();
  }

  /** Has the workers wait, or go on. */
  synchronized void hold(boolean wait) {
    held = wait;
    notifyAll();
  }
}
