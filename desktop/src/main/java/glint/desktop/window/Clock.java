package glint.desktop.window;

/** A watch that can be stopped; thread-safe. */
final class Clock {

  private long began = System.nanoTime();
  private long stopped = -1;

  /** Returns the time that it has run, in seconds. */
  synchronized double seconds() {
    return ((stopped < 0 ? System.nanoTime() - began : stopped)) * 1e-9;
  }

  /** Stops it. */
  synchronized void stop() {
    if (stopped < 0) {
      stopped = System.nanoTime() - began;
    }
  }

  /** Lets it run on. */
  synchronized void go() {
    if (stopped >= 0) {
      began = System.nanoTime() - stopped;
      stopped = -1;
    }
  }
}
