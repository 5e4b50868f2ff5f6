package glint.android;

/** A watch that can be stopped; thread-safe. */
final class Clock {

  private long began;
  private long before;
  private boolean running;

  /** Lets it run. */
  synchronized void go() {
    if (!running) {
      began = System.nanoTime();
      running = true;
    }
  }

  /** Stops it. */
  synchronized void stop() {
    before = nanos();
    running = false;
  }

  /** Returns the time that it has run, in seconds. */
  synchronized double seconds() {
    return nanos() * 1e-9;
  }

  private long nanos() {
    return before + (running ? System.nanoTime() - began : 0);
  }
}
