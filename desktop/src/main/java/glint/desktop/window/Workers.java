package glint.desktop.window;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;

/** The threads that do for the window what would make it wait. */
final class Workers {

  private final ThreadFactory factory =
      work -> {
        Thread thread = new Thread(work, "glint-window-work");
        thread.setDaemon(true);
        return thread;
      };
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(factory);
  private final ExecutorService disk = Executors.newSingleThreadExecutor(factory);
  private final ExecutorService brains = Executors.newFixedThreadPool(2, factory);

  /** Reads or writes soon, after what was asked for before; does nothing when all is ended. */
  void disk(Runnable work) {
    run(disk, work);
  }

  /** Computes something soon; nothing when all is ended. */
  void compute(Runnable work) {
    run(brains, work);
  }

  private static void run(ExecutorService line, Runnable work) {
    try {
      line.execute(work);
    } catch (RejectedExecutionException e) {
      return; // the window is closed
    }
  }

  /** Does work again and again, with a pause after each time. */
  void every(long millis, Runnable work) {
    var unused = clock.scheduleWithFixedDelay(work, millis, millis, TimeUnit.MILLISECONDS);
  }

  /** Ends all threads; what is being written is finished. */
  void end() {
    clock.shutdownNow();
    disk.shutdown();
    brains.shutdown();
  }
}
