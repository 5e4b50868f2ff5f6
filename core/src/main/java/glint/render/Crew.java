package glint.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;

/**
 * The threads of a render, each with a worker of its own; together they work through numbered
 * tasks.
 *
 * @param <W> what a thread works with
 */
final class Crew<W> implements AutoCloseable {

  /** One kind of work. */
  interface Task<W> {
    /** Does the part with a number. */
    void run(W worker, int number);
  }

  /** Small tasks that a thread does in one go. */
  private static final int BATCH = 64;

  private final List<W> workers;
  private final BooleanSupplier cancelled;
  private final ExecutorService pool;

  /** Starts a thread for every worker. */
  Crew(List<W> workers, BooleanSupplier cancelled, ThreadFactory threads) {
    this.workers = workers;
    this.cancelled = cancelled;
    pool = Executors.newFixedThreadPool(workers.size(), threads);
  }

  List<W> workers() {
    return workers;
  }

  /**
   * Does the tasks with the numbers from 0, and returns when all are done.
   *
   * @throws InterruptedException if the calling thread was interrupted meanwhile
   * @throws CancellationException if the render was cancelled
   */
  void run(int tasks, Task<W> task) throws InterruptedException {
    AtomicInteger next = new AtomicInteger();
    List<Future<?>> pending = new ArrayList<>();
    for (W worker : workers.subList(0, Math.min(workers.size(), tasks))) {
      pending.add(pool.submit(() -> work(worker, next, tasks, task)));
    }
    for (Future<?> each : pending) {
      try {
        each.get();
      } catch (ExecutionException e) {
        throw new IllegalStateException("rendering failed: " + e.getCause(), e.getCause());
      }
    }
    if (cancelled.getAsBoolean()) {
      throw new CancellationException("rendering was cancelled");
    }
  }

  /** Does tasks that are many and small, like {@link #run}. */
  void runInBatches(int tasks, Task<W> task) throws InterruptedException {
    run(
        (tasks + BATCH - 1) / BATCH,
        (worker, batch) -> {
          for (int i = BATCH * batch; i < Math.min(tasks, BATCH * (batch + 1)); i++) {
            task.run(worker, i);
          }
        });
  }

  private void work(W worker, AtomicInteger next, int tasks, Task<W> task) {
    for (int i = next.getAndIncrement(); i < tasks; i = next.getAndIncrement()) {
      if (cancelled.getAsBoolean()) {
        return;
      }
      task.run(worker, i);
    }
  }

  @Override
  public void close() {
    pool.shutdownNow();
  }
}
