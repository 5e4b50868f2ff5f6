package glint.android;

import android.os.Process;
import java.util.concurrent.ThreadFactory;

/** Makes threads of the priorities that the app's work has. */
final class Threads {

  /** For what a person waits for: as the app's own thread, but that one comes first. */
  static final int AWAITED =
      Process.THREAD_PRIORITY_DEFAULT + Process.THREAD_PRIORITY_LESS_FAVORABLE;

  /** For what may take its time. */
  static final int BESIDES = Process.THREAD_PRIORITY_BACKGROUND;

  private Threads() {}

  /** Returns what makes threads of a name and a priority of {@link Process}. */
  static ThreadFactory of(String name, int priority) {
    return work -> {
      Runnable atPriority =
          () -> {
            Process.setThreadPriority(priority);
            work.run();
          };
      Thread thread = new Thread(atPriority, name);
      thread.setDaemon(true);
      return thread;
    };
  }
}
