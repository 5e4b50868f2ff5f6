package glint.desktop;

import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import javax.swing.SwingUtilities;

/** The thread that windows belong to. */
final class EventThread {

  private EventThread() {}

  /** Returns what the event thread makes of something. */
  static <T> T on(Callable<T> work) {
    if (SwingUtilities.isEventDispatchThread()) {
      try {
        return work.call();
      } catch (Exception e) {
        throw new IllegalStateException(e);
      }
    }
    FutureTask<T> task = new FutureTask<>(work);
    try {
      SwingUtilities.invokeAndWait(task);
      return task.get();
    } catch (InterruptedException | InvocationTargetException | ExecutionException e) {
      throw new IllegalStateException(e);
    }
  }
}
