package glint.android;

import android.graphics.Bitmap;
import android.os.Handler;
import android.os.Looper;
import glint.image.Image;
import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ThreadFactory;

/**
 * Small pictures of scenes, rendered one after the other as they are asked for, and kept; used on
 * the main thread.
 */
final class Thumbnails {

  /** The longer side of a picture. */
  private static final int SIDE = 160;

  /** Good enough for a small picture; what takes longer is shown as it is then. */
  private static final Goal GOAL = new Goal.Error(4, 2);

  private final ThumbnailCache cache;
  private final Map<Scene, Bitmap> pictures = new IdentityHashMap<>();
  private final Handler main = new Handler(Looper.getMainLooper());
  private final ExecutorService worker =
      Executors.newSingleThreadExecutor(Threads.of("glint-thumbnails", Threads.BESIDES));

  private Runnable watcher = () -> {};

  /** What is rendered now; guarded by this, like the two below. */
  private Renderer renderer;

  private boolean held;
  private boolean closed;

  /** Makes none yet. */
  Thumbnails(ThumbnailCache cache) {
    this.cache = cache;
  }

  /** Sets who is told of new pictures, on the main thread. */
  void watch(Runnable newWatcher) {
    watcher = newWatcher;
  }

  /**
   * Returns a scene's picture, or null, and has it made then.
   *
   * @param digest a hash of the bytes of the scene's file
   */
  Bitmap of(Scene scene, String digest) {
    if (!pictures.containsKey(scene)) {
      pictures.put(scene, null);
      worker.execute(() -> find(scene, digest));
    }
    return pictures.get(scene);
  }

  private void find(Scene scene, String digest) {
    Bitmap kept = cache.read(digest, scene.name());
    if (kept == null) {
      make(scene, digest);
    } else {
      main.post(() -> show(scene, kept));
    }
  }

  private void make(Scene scene, String digest) {
    double scale = (double) SIDE / Math.max(scene.width(), scene.height());
    int width = (int) Math.max(1, scale * scene.width());
    int height = (int) Math.max(1, scale * scene.height());
    if (!Heap.now().holds(scene, width, height)) {
      return;
    }
    try {
      RenderSettings how =
          new RenderSettings(
              width,
              height,
              GOAL,
              0,
              OptionalInt.empty(),
              Settings.mostThreads(),
              RenderSettings.DEFAULT_TILE,
              Set.of());
      Renderer next = new Renderer(Prepared.of(scene), how);
      begin(next);
      ThreadFactory threads = Threads.of("glint-thumbnail", Threads.BESIDES);
      Image image = next.render(Progress.NONE, threads).image();
      int[] codes = image.toArgb(scene.transfer());
      Bitmap bitmap = Bitmap.createBitmap(codes, width, height, Bitmap.Config.ARGB_8888);
      cache.write(digest, scene.name(), bitmap);
      main.post(() -> show(scene, bitmap));
    } catch (CancellationException e) {
      // nobody will look at it
    } catch (OutOfMemoryError | IllegalStateException e) {
      // of a worker, too: a list does without
    }
  }

  private void show(Scene scene, Bitmap bitmap) {
    pictures.replace(scene, bitmap);
    watcher.run();
  }

  private synchronized void begin(Renderer next) {
    renderer = next;
    if (held) {
      next.pause();
    }
    if (closed) {
      next.cancel();
    }
  }

  /** Has the work wait while nobody can see it, or go on. */
  synchronized void hold(boolean wait) {
    held = wait;
    if (renderer != null && wait) {
      renderer.pause();
    } else if (renderer != null) {
      renderer.resume();
    }
  }

  /** Lets go of all pictures; they are made again as they are asked for. */
  void forget() {
    pictures.clear();
  }

  /** Ends all work. */
  synchronized void close() {
    closed = true;
    worker.shutdownNow();
    if (renderer != null) {
      renderer.cancel();
    }
  }
}
