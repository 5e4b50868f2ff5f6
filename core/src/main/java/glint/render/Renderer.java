package glint.render;

import glint.image.Image;
import glint.scene.Prepared;
import glint.trace.RayCounts;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Renders one image: cuts it into tiles and runs them on a fixed pool of threads.
 *
 * <p>The image is the same, bit for bit, for any number of threads and any size of tiles.
 */
public final class Renderer {

  private final Prepared scene;
  private final RenderSettings settings;
  private final Image image;
  private final Map<Aov, Image> aovs = new EnumMap<>(Aov.class);
  private final ConcurrentLinkedQueue<Worker> idle = new ConcurrentLinkedQueue<>();
  private final List<Worker> workers = new ArrayList<>();
  private volatile boolean cancelled;
  private Progress progress = Progress.NONE;
  private int total;
  private int done;
  private long rays;

  /** Sets up a render; nothing runs yet. */
  public Renderer(Prepared scene, RenderSettings settings) {
    this.scene = scene;
    this.settings = settings;
    image = new Image(settings.width(), settings.height());
    for (Aov aov : settings.aovs()) {
      aovs.put(aov, new Image(settings.width(), settings.height()));
    }
  }

  /**
   * Renders the image; call it once.
   *
   * @throws CancellationException if {@link #cancel} was called, or the thread was interrupted
   */
  public RenderResult render(Progress listener) {
    progress = listener;
    long began = System.nanoTime();
    ExecutorService pool = Executors.newFixedThreadPool(settings.threads(), Renderer::thread);
    try {
      List<Tile> tiles = tiles();
      total = tiles.size();
      List<Future<?>> pending = new ArrayList<>();
      for (Tile tile : tiles) {
        pending.add(pool.submit(tile));
      }
      for (Future<?> tile : pending) {
        tile.get();
      }
    } catch (InterruptedException e) {
      cancel();
      Thread.currentThread().interrupt();
    } catch (ExecutionException e) {
      cancel();
      throw new IllegalStateException("rendering failed: " + e.getCause(), e.getCause());
    } finally {
      pool.shutdownNow();
    }
    if (cancelled) {
      throw new CancellationException("rendering was cancelled");
    }
    double seconds = (System.nanoTime() - began) * 1e-9;
    return new RenderResult(image, aovs, statistics(seconds));
  }

  /** Stops the render soon; may be called from any thread. */
  public void cancel() {
    cancelled = true;
  }

  /** Returns the image, not a copy: it grows while tiles finish. */
  public Image image() {
    return image;
  }

  boolean isCancelled() {
    return cancelled;
  }

  /** Lends out an idle worker, or a new one: there are never more than threads. */
  Worker hire() {
    Worker worker = idle.poll();
    if (worker == null) {
      worker = new Worker(scene, settings, image, aovs);
      synchronized (workers) {
        workers.add(worker);
      }
    }
    return worker;
  }

  /** Takes back a worker whose tile is finished, and tells the listener. */
  void finish(Worker worker) {
    idle.add(worker);
    synchronized (workers) {
      done++;
      rays += worker.newRays();
      progress.tileDone(done, total, rays);
    }
  }

  private List<Tile> tiles() {
    int edge = settings.tileSize();
    List<Tile> tiles = new ArrayList<>();
    for (int y = 0; y < settings.height(); y += edge) {
      for (int x = 0; x < settings.width(); x += edge) {
        int x1 = Math.min(x + edge, settings.width());
        int y1 = Math.min(y + edge, settings.height());
        tiles.add(new Tile(this, x, y, x1, y1));
      }
    }
    return tiles;
  }

  private Statistics statistics(double seconds) {
    RayCounts counts = new RayCounts();
    long invalid = 0;
    for (Worker worker : workers) {
      counts.add(worker.counts());
      invalid += worker.invalid();
    }
    int samples = settings.samples();
    return new Statistics(
        counts,
        samples,
        samples,
        samples,
        scene.primitiveCount(),
        invalid,
        ImageFacts.clipped(image),
        seconds,
        ImageFacts.sha256(image));
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "glint-render");
    thread.setDaemon(true);
    return thread;
  }
}
