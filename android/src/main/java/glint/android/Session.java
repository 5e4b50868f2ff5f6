package glint.android;

import android.graphics.Bitmap;
import android.os.Handler;
import android.os.Looper;
import glint.android.Status.State;
import glint.render.Goal;
import glint.render.RenderSettings;
import glint.scene.Camera;
import glint.scene.Decision;
import glint.scene.Scene;
import glint.scene.World;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;

/**
 * The renders of one scene, which outlive the activity that shows them while it is turned; used on
 * the main thread.
 */
final class Session {

  private final Settings settings;
  private final Handler main = new Handler(Looper.getMainLooper());
  private final ExecutorService worker =
      Executors.newSingleThreadExecutor(Threads.of("glint-session", Threads.AWAITED));
  private final ScheduledExecutorService painter =
      Executors.newSingleThreadScheduledExecutor(Threads.of("glint-paint", Threads.AWAITED));
  private final World world;
  private final Coarseness coarseness = new Coarseness();

  private Camera camera;
  private int halvings;
  private Run run;
  private Bitmap last;
  private boolean moving;
  private boolean paused;
  private boolean away;
  private Runnable watcher = () -> {};

  /** Begins to render a scene as seen by a camera, as large as memory allows. */
  Session(Scene scene, Camera camera, Settings settings) {
    world = new World(scene);
    this.camera = camera;
    this.settings = settings;
    int width = settings.size().width(scene);
    int height = settings.size().height(scene);
    halvings = Heap.now().halvings(scene, width, height);
    begin(width(), height(), new Goal.Error(settings.levels()));
  }

  private void begin(int width, int height, Goal goal) {
    RenderSettings how =
        new RenderSettings(
            width,
            height,
            goal,
            0,
            OptionalInt.empty(),
            settings.threads(),
            RenderSettings.DEFAULT_TILE,
            Set.of());
    last = run == null ? null : bitmap();
    Scene picture = world.scene().seenBy(camera, width, height);
    run = new Run(world, picture, how, painter, () -> main.post(this::changed));
    run.hold(paused || away);
    worker.execute(run);
  }

  private void changed() {
    if (moving && run.status().state() == State.DONE) {
      coarseness.learn(run.status().seconds());
      if (!run.sees(camera)) {
        beginCoarse();
      }
    }
    watcher.run();
  }

  private void beginCoarse() {
    begin(coarseness.of(width()), coarseness.of(height()), new Goal.Samples(1));
  }

  /** Sees the scene by another camera; coarsely, but soon, as long as that is still moving. */
  void look(Camera to, boolean stillMoving) {
    camera = to;
    if (!stillMoving) {
      run.cancel();
      begin(width(), height(), new Goal.Error(settings.levels()));
    } else if (!moving || run.status().state().isOver()) {
      run.cancel();
      beginCoarse();
    }
    moving = stillMoving;
  }

  /** Sets who is told of changes, on the main thread. */
  void watch(Runnable newWatcher) {
    watcher = newWatcher;
  }

  /** Returns the scene as it was read. */
  Scene scene() {
    return world.scene();
  }

  /** Returns the camera that sees it now. */
  Camera camera() {
    return camera;
  }

  /** Returns whether the camera is being moved. */
  boolean isMoving() {
    return moving;
  }

  /** Returns the columns of the picture. */
  int width() {
    return settings.size().width(world.scene()) >> halvings;
  }

  /** Returns the rows of the picture. */
  int height() {
    return settings.size().height(world.scene()) >> halvings;
  }

  /** Returns whether the picture is smaller than was asked for, as memory is short. */
  boolean isShrunk() {
    return halvings > 0;
  }

  /** Returns how far the render has come. */
  Status status() {
    return run.status();
  }

  /** Returns the picture, which grows; null before there is anything to see. */
  Bitmap bitmap() {
    Bitmap picture = run.bitmap();
    return picture == null ? last : picture;
  }

  /** Returns what the scene needs, and what is left out; empty before it is prepared. */
  List<Decision> plan() {
    return run.plan();
  }

  /** Returns whether a person has paused the render. */
  boolean isPaused() {
    return paused;
  }

  /** Has the render wait, or go on, as a person wishes. */
  void pause(boolean wait) {
    paused = wait;
    run.hold(paused || away);
  }

  /** Has the render wait while nobody can see it, or go on. */
  void leave(boolean nobodyThere) {
    away = nobodyThere;
    run.hold(paused || away);
  }

  /**
   * Begins again with a picture of half the size, unless the render is over or that is too small.
   */
  void shrink() {
    boolean large = Math.min(width(), height()) / 2 >= Heap.LEAST_SIDE;
    if (large && !run.status().state().isOver()) {
      run.cancel();
      halvings++;
      begin(width(), height(), new Goal.Error(settings.levels()));
    }
  }

  /** Ends all work. */
  void close() {
    run.cancel();
    worker.shutdown();
    painter.shutdown();
  }
}
