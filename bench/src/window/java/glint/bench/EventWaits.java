package glint.bench;

import java.util.concurrent.atomic.AtomicLong;
import javax.swing.SwingUtilities;

/** How long an event has to wait at most until the event thread takes it up. */
final class EventWaits extends Thread {

  private static final int PAUSE_MILLIS = 2;

  private final AtomicLong longest = new AtomicLong();

  /** Starts to measure. */
  EventWaits() {
    super("event-waits");
    setDaemon(true);
    setPriority(MAX_PRIORITY);
    start();
  }

  @Override
  public void run() {
    try {
      while (true) {
        long asked = System.nanoTime();
        SwingUtilities.invokeAndWait(
            () -> longest.accumulateAndGet(System.nanoTime() - asked, Math::max));
        Thread.sleep(PAUSE_MILLIS);
      }
    } catch (InterruptedException | java.lang.reflect.InvocationTargetException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns the longest wait since it was last asked, in milliseconds. */
  double take() {
    return longest.getAndSet(0) * 1e-6;
  }
}
