package glint.render;

import glint.image.Image;
import glint.scene.Prepared;
import glint.trace.RayCounts;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Renders one image: cuts it into tiles and runs them on a fixed pool of threads.
 *
 * <p>The image is the same, bit for bit, for any number of threads and any size of tiles.
 */
public final class Renderer {

  private final Prepared scene;
  private final RenderSettings settings;
  private final Image image;
  private final double[] cut;
  private final Map<Aov, Image> aovs = new EnumMap<>(Aov.class);
  private final AtomicInteger nextTile = new AtomicInteger();
  private volatile boolean cancelled;
  private Progress progress = Progress.NONE;
  private final int columns;
  private final int total;
  private int done;
  private long rays;

  /** Sets up a render; nothing runs yet. */
  public Renderer(Prepared scene, RenderSettings settings) {
    this.scene = scene;
    this.settings = settings;
    image = new Image(settings.width(), settings.height());
    cut = new double[settings.width() * settings.height()];
    columns = tiles(settings.width());
    total = Math.multiplyExact(columns, tiles(settings.height()));
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
    List<Worker> workers = new ArrayList<>();
    List<Future<?>> pending = new ArrayList<>();
    ExecutorService pool = Executors.newFixedThreadPool(settings.threads(), Renderer::thread);
    try {
      for (int i = 0; i < Math.min(settings.threads(), total); i++) {
        Worker worker = new Worker(this, scene, settings, image, cut, aovs);
        workers.add(worker);
        pending.add(pool.submit(() -> work(worker)));
      }
      for (Future<?> each : pending) {
        each.get();
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
    return new RenderResult(image, aovs, statistics(workers, seconds));
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

  /** Tells the listener of a finished tile. */
  synchronized void tileDone(Worker worker) {
    if (!cancelled) {
      done++;
      rays += worker.newRays();
      progress.tileDone(done, total, rays);
    }
  }

  /** Runs tile after tile until there are no more. */
  private void work(Worker worker) {
    for (int i = nextTile.getAndIncrement(); i < total; i = nextTile.getAndIncrement()) {
      if (cancelled) {
        return;
      }
      tile(worker, i).run();
    }
  }

  private Tile tile(Worker worker, int number) {
    int edge = settings.tileSize();
    int x = number % columns * edge;
    int y = number / columns * edge;
    int x1 = Math.min(x + edge, settings.width());
    int y1 = Math.min(y + edge, settings.height());
    return new Tile(this, worker, x, y, x1, y1);
  }

  private int tiles(int side) {
    return (side - 1) / settings.tileSize() + 1;
  }

  private Statistics statistics(List<Worker> workers, double seconds) {
    RayCounts counts = new RayCounts();
    long invalid = 0;
    int invalidPixel = Integer.MAX_VALUE;
    for (Worker worker : workers) {
      counts.add(worker.counts());
      invalid += worker.invalid();
      invalidPixel = Math.min(invalidPixel, worker.invalidPixel());
    }
    int samples = settings.samples();
    return new Statistics(
        counts,
        samples,
        samples,
        samples,
        scene.primitiveCount(),
        scene.geometryBytes(),
        invalid,
        invalidPixel,
        ImageFacts.clipped(image),
        ImageFacts.truncation(image, cut, scene.scene().transfer()),
        seconds,
        ImageFacts.sha256(image));
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "glint-render");
    thread.setDaemon(true);
    return thread;
  }
}
