package glint.bench;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.atomic.AtomicLong;
import javax.swing.SwingUtilities;

/**
 * How long an event has to wait at most until the event thread takes it up, and how long that
 * thread itself works at one at most, whatever else the machine does.
 */
final class EventWaits extends Thread {

  private static final int PAUSE_MILLIS = 2;

  private final AtomicLong longestWait = new AtomicLong();
  private final AtomicLong longestWork = new AtomicLong();

  /** Starts to measure. */
  EventWaits() {
    super("event-waits");
    setDaemon(true);
    Toolkit.getDefaultToolkit().getSystemEventQueue().push(new Timed());
    start();
  }

  private final class Timed extends EventQueue {
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();

    @Override
    protected void dispatchEvent(AWTEvent event) {
      long began = threads.getCurrentThreadCpuTime();
      super.dispatchEvent(event);
      longestWork.accumulateAndGet(threads.getCurrentThreadCpuTime() - began, Math::max);
    }
  }

  @Override
  public void run() {
    try {
      while (true) {
        long asked = System.nanoTime();
        SwingUtilities.invokeAndWait(
            () -> longestWait.accumulateAndGet(System.nanoTime() - asked, Math::max));
        Thread.sleep(PAUSE_MILLIS);
      }
    } catch (InterruptedException | InvocationTargetException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns the longest wait since it was last asked, in milliseconds. */
  double takeWait() {
    return longestWait.getAndSet(0) * 1e-6;
  }

  /** Returns the longest work, in milliseconds of the processor, since it was last asked. */
  double takeWork() {
    return longestWork.getAndSet(0) * 1e-6;
  }
}
