package glint.render;

/** A watch that begins at zero, stopped; thread-safe. */
public final class Stopwatch {

  private long began;
  private long before;
  private boolean running;

  /** Lets it run, or run on. */
  public synchronized void go() {
    if (!running) {
      began = System.nanoTime();
      running = true;
    }
  }

  /** Stops it. */
  public synchronized void stop() {
    before = nanos();
    running = false;
  }

  /** Returns the time that it has run, in seconds. */
  public synchronized double seconds() {
    return nanos() * 1e-9;
  }

  private long nanos() {
    return before + (running ? System.nanoTime() - began : 0);
  }
}
