package glint.android;

import android.graphics.Bitmap;
import glint.android.Status.State;
import glint.render.Goal;
import glint.render.Outlook;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.render.Stopwatch;
import glint.scene.Camera;
import glint.scene.Decision;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.scene.World;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/** One render of a scene, and the bitmap that shows how far it has come; thread-safe. */
final class Run implements Runnable, Progress {

  /** Between two looks at a picture that grows. */
  private static final long PAUSE_MILLIS = 40;

  private final World world;
  private final Scene picture;
  private final RenderSettings settings;
  private final ScheduledExecutorService painter;
  private final Runnable changed;
  private final Outlook outlook;
  private final Stopwatch watch = new Stopwatch();
  private final AtomicBoolean asked = new AtomicBoolean();
  private final Bitmap bitmap;

  private Prepared prepared;
  private Renderer renderer;
  private State state = State.PREPARING;
  private boolean held;
  private boolean shown;
  private long rays;
  private double error = Double.POSITIVE_INFINITY;

  /**
   * Sets up a render.
   *
   * @param painter on whose thread the bitmap is brought up to date
   * @param changed told of every change, on any thread
   */
  Run(
      World world,
      Scene picture,
      RenderSettings settings,
      ScheduledExecutorService painter,
      Runnable changed) {
    this.world = world;
    this.picture = picture;
    this.settings = settings;
    this.painter = painter;
    this.changed = changed;
    double target =
        settings.goal() instanceof Goal.Error error ? error.levels() : Double.POSITIVE_INFINITY;
    outlook = new Outlook(target);
    bitmap = Bitmap.createBitmap(settings.width(), settings.height(), Bitmap.Config.ARGB_8888);
  }

  /** Renders; returns when the picture is finished or the render has ended otherwise. */
  @Override
  public void run() {
    try {
      if (!Heap.now().holds(picture, settings.width(), settings.height())) {
        end(State.REFUSED);
        return;
      }
      if (begin(world.seenIn(picture))) {
        ThreadFactory threads = Threads.of("glint-render", Threads.AWAITED);
        RenderResult result = renderer.render(this, threads);
        paint();
        finish(result.statistics().samplingError());
      }
    } catch (CancellationException e) {
      end(State.STOPPED);
    } catch (OutOfMemoryError e) {
      end(State.OUT_OF_MEMORY);
    } catch (IllegalStateException e) {
      if (!(e.getCause() instanceof OutOfMemoryError)) { // of a worker
        throw e;
      }
      end(State.OUT_OF_MEMORY);
    }
  }

  /** Returns whether there is still something to begin. */
  private synchronized boolean begin(Prepared world) {
    if (state.isOver()) {
      return false;
    }
    prepared = world;
    renderer = new Renderer(prepared, settings);
    if (held) {
      renderer.pause();
    }
    state = held ? State.PAUSED : State.RENDERING;
    if (!held) {
      watch.go();
    }
    changed.run();
    return true;
  }

  private void finish(double claimed) {
    synchronized (this) {
      error = claimed;
    }
    end(State.DONE);
  }

  /** Stops it soon, unless it is over. */
  void cancel() {
    end(State.STOPPED);
  }

  private synchronized void end(State last) {
    if (state.isOver()) {
      return;
    }
    state = last;
    watch.stop();
    if (renderer != null) {
      renderer.cancel();
    }
    changed.run();
  }

  /** Has it wait, or go on. */
  synchronized void hold(boolean wait) {
    held = wait;
    if (renderer == null || state.isOver()) {
      return;
    }
    if (wait) {
      renderer.pause();
      watch.stop();
    } else {
      renderer.resume();
      watch.go();
    }
    state = wait ? State.PAUSED : State.RENDERING;
    changed.run();
  }

  /** Returns how far it has come. */
  synchronized Status status() {
    double seconds = watch.seconds();
    double part = state == State.DONE ? 1 : outlook.done(seconds);
    return new Status(state, part, seconds, outlook.left(seconds), rays, error);
  }

  /** Returns the picture, which grows; null before there is anything to see. */
  synchronized Bitmap bitmap() {
    return shown ? bitmap : null;
  }

  /** Returns whether it is a picture by a camera. */
  boolean sees(Camera camera) {
    return picture.camera().equals(camera);
  }

  /** Returns what the scene needs, and what is left out; empty before it is prepared. */
  synchronized List<Decision> plan() {
    return prepared == null ? List.of() : prepared.plan().decisions();
  }

  @Override
  public void tileDone(int done, int total, long traced) {
    outlook.tiles((double) done / total, watch.seconds());
    synchronized (this) {
      rays = traced;
    }
    repaint();
  }

  @Override
  public void pictureImproved(double claimed, long traced) {
    if (claimed < Double.POSITIVE_INFINITY) {
      outlook.error(claimed, watch.seconds());
    }
    synchronized (this) {
      rays = traced;
      error = claimed;
    }
    repaint();
  }

  /** Has the picture painted soon; never once the render is over, as then the painter may be. */
  private synchronized void repaint() {
    if (!state.isOver() && asked.compareAndSet(false, true)) {
      painter.schedule(
          () -> {
            asked.set(false);
            paint();
            changed.run();
          },
          PAUSE_MILLIS,
          TimeUnit.MILLISECONDS);
    }
  }

  private void paint() {
    int width = settings.width();
    int[] codes = renderer.image().toArgb(picture.transfer());
    synchronized (this) {
      bitmap.setPixels(codes, 0, width, 0, 0, width, settings.height());
      shown = true;
    }
  }
}
