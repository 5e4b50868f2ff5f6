package glint.desktop.window;

import glint.image.Image;
import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CancellationException;

/**
 * Small pictures of scenes: those that are kept on disk at once, others are rendered by one thread
 * while nothing else is; thread-safe.
 */
final class Thumbnails {

  /** The box that a picture fits into, in pixels of a display of many; shown half as large. */
  static final int WIDTH = 144;

  static final int HEIGHT = 96;

  private static final Goal GOAL = new Goal.Error(4, 20);

  private final ThumbnailCache cache;
  private final Runnable changed;
  private final Map<String, BufferedImage> made = new HashMap<>();
  private final Set<String> hopeless = new HashSet<>();
  private List<Picked> wanted = List.of();
  private boolean news;
  private boolean idle;
  private boolean ended;
  private Renderer renderer;

  /**
   * Sets up a place without pictures.
   *
   * @param changed hears, on any thread, that there is another picture
   */
  Thumbnails(ThumbnailCache cache, Runnable changed) {
    this.cache = cache;
    this.changed = changed;
    Thread thread = new Thread(this::work, "glint-window-thumbnails");
    thread.setDaemon(true);
    thread.setPriority(Thread.MIN_PRIORITY);
    thread.start();
  }

  /** Returns the picture of a scene, if there is one already. */
  synchronized Optional<BufferedImage> of(Picked picked) {
    return Optional.ofNullable(made.get(ThumbnailCache.key(picked)));
  }

  /** Wants pictures of these scenes, in this order, and no longer of others. */
  synchronized void want(List<Picked> scenes) {
    wanted = List.copyOf(scenes);
    news = true;
    notifyAll();
  }

  /** Allows rendering, or stops it at once. */
  synchronized void allow(boolean now) {
    news |= now && !idle;
    idle = now;
    if (!idle && renderer != null) {
      renderer.cancel();
    }
    notifyAll();
  }

  /** Ends the thread. */
  synchronized void end() {
    ended = true;
    allow(false);
  }

  private void work() {
    cache.prune();
    for (List<Picked> todo = await(); !ended(); todo = await()) {
      for (Picked picked : todo) {
        if (of(picked).isEmpty()) {
          cache.read(picked).ifPresent(picture -> keep(picked, picture));
        }
      }
      for (Picked picked : todo) {
        if (of(picked).isEmpty() && mayRender(picked)) {
          render(picked);
        }
      }
    }
  }

  /** Waits for news and returns what is wanted then. */
  private synchronized List<Picked> await() {
    while (!news && !ended) {
      try {
        wait();
      } catch (InterruptedException e) {
        throw new IllegalStateException("nothing interrupts this thread", e);
      }
    }
    news = false;
    return wanted;
  }

  private synchronized boolean ended() {
    return ended;
  }

  private synchronized boolean mayRender(Picked picked) {
    return idle && !news && !hopeless.contains(ThumbnailCache.key(picked));
  }

  private void keep(Picked picked, BufferedImage picture) {
    synchronized (this) {
      made.put(ThumbnailCache.key(picked), picture);
    }
    changed.run();
  }

  /** Makes the picture of a scene and keeps it, unless that is stopped. */
  private void render(Picked picked) {
    Scene scene = picked.scene();
    double scale = Math.min(WIDTH / (double) scene.width(), HEIGHT / (double) scene.height());
    int width = Math.max(1, (int) Math.rint(scale * scene.width()));
    int height = Math.max(1, (int) Math.rint(scale * scene.height()));
    RenderSettings settings =
        new RenderSettings(width, height, GOAL, 0, OptionalInt.empty(), 1, 32, Set.of());
    try {
      Renderer next = new Renderer(Prepared.of(scene), settings);
      synchronized (this) {
        renderer = next;
        if (!idle) {
          return;
        }
      }
      Image image = next.render(Progress.NONE).image();
      BufferedImage picture = Pictures.of(image, scene.transfer());
      cache.write(picked, picture);
      keep(picked, picture);
    } catch (CancellationException e) {
      return; // another time
    } catch (RuntimeException | OutOfMemoryError e) {
      synchronized (this) {
        hopeless.add(ThumbnailCache.key(picked));
      }
    } finally {
      synchronized (this) {
        renderer = null;
      }
    }
  }
}
