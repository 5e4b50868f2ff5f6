package glint.desktop.window;

import glint.desktop.window.Snapshot.State;
import glint.image.Image;
import glint.render.Aov;
import glint.render.Goal;
import glint.render.Outlook;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.render.Statistics;
import glint.render.Stopwatch;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.scene.World;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;

/**
 * The render of one scene in the background, as {@code glint render} does it by default.
 *
 * <p>One thread renders, with the workers that it starts; another turns what there is into pictures
 * for the display, whenever a round is over and else now and then.
 */
final class RenderRun {

  /** The least time between two pictures. */
  private static final long PAUSE_MILLIS = 40;

  /** The first look has so many times fewer columns and rows than the image. */
  private static final int GLIMPSE = 16;

  /** The first picture of a render has one colour for so many columns and rows. */
  private static final int COARSE = 8;

  /** Pictures take at most one of so many parts of a thread's time. */
  private static final int SHARE = 5;

  private final World world;
  private final Scene scene;
  private final RenderSettings settings;
  private final Marks marks;
  private final Outlook outlook;
  private final Heard heard;
  private final Consumer<Snapshot> listener;
  private final Stopwatch watch = new Stopwatch();
  private final Object change = new Object();
  private State state = State.PREPARING;
  private Prepared prepared;
  private Renderer renderer;
  private Statistics statistics;
  private boolean improved;
  private String message = "";

  /**
   * Sets up a render; nothing runs yet.
   *
   * @param scene a picture of the world
   * @param before what is shown of it already, of any size
   * @param listener hears of every change, on the thread that makes the pictures
   */
  RenderRun(World world, Scene scene, Optional<BufferedImage> before, Consumer<Snapshot> listener) {
    this.world = world;
    this.scene = scene;
    this.listener = listener;
    RenderSettings plain = RenderSettings.of(scene);
    settings = plain.aiming(plain.goal(), plain.seed(), Set.of(Aov.ERROR, Aov.SAMPLES));
    marks = new Marks(before);
    outlook = new Outlook(((Goal.Error) settings.goal()).levels());
    heard = new Heard(watch, marks, outlook, this::improved);
  }

  /** Begins. */
  void start() {
    watch.go();
    thread("glint-window-render", this::render).start();
    thread("glint-window-picture", this::show).start();
  }

  /** Has the render wait, or go on; does nothing when it is over. */
  void pause(boolean wait) {
    synchronized (change) {
      if (renderer == null || state.isOver()) {
        return;
      }
      if (wait) {
        renderer.pause();
        watch.stop();
      } else {
        watch.go();
        renderer.resume();
      }
      state = wait ? State.PAUSED : State.RENDERING;
      changed();
    }
  }

  /** Ends the render soon; what it has shown stays. */
  void stop() {
    finish(State.STOPPED, "");
  }

  private void render() {
    try {
      prepared = world.seenIn(scene);
      if (marks.before().isEmpty()) {
        marks.show(Glimpse.of(world, scene, GLIMPSE));
        synchronized (change) {
          changed();
        }
      }
      Renderer next = new Renderer(prepared, settings);
      if (begin(next)) {
        Statistics all = next.render(heard).statistics();
        heard.ended(all.samplingError());
        synchronized (change) {
          statistics = all;
        }
        finish(State.DONE, "");
      }
    } catch (CancellationException e) {
      finish(State.STOPPED, "");
    } catch (OutOfMemoryError e) {
      finish(State.FAILED, "not enough memory");
    } catch (RuntimeException e) {
      finish(State.FAILED, String.valueOf(e.getMessage()));
    }
  }

  /** Returns whether there is still something to begin. */
  private boolean begin(Renderer next) {
    synchronized (change) {
      if (state.isOver()) {
        return false;
      }
      renderer = next;
      state = State.RENDERING;
      changed();
      return true;
    }
  }

  private void finish(State last, String reason) {
    synchronized (change) {
      if (!state.isOver()) {
        state = last;
        message = reason;
        watch.stop();
        if (renderer != null) {
          renderer.cancel();
        }
        changed();
      }
    }
  }

  private void changed() {
    improved = true;
    change.notifyAll();
  }

  private void improved(double claimed) {
    if (claimed == Double.POSITIVE_INFINITY) {
      marks.show(Pictures.everyNth(renderer.image(), COARSE, scene.transfer()));
    }
    synchronized (change) {
      changed();
    }
  }

  private void show() {
    State told;
    long wait = 0;
    do {
      told = await(wait);
      long began = System.nanoTime();
      listener.accept(snapshot(told));
      wait = Math.max(PAUSE_MILLIS, (SHARE - 1) * (System.nanoTime() - began) / 1_000_000);
    } while (told != null && !told.isOver());
  }

  /** Waits for a change, or for so long while rendering; returns where the render stands then. */
  private State await(long millis) {
    synchronized (change) {
      long end = System.nanoTime() + millis * 1_000_000;
      boolean moving = state == State.RENDERING && heard.isShown();
      while (!improved && !(moving && System.nanoTime() - end >= 0)) {
        try {
          change.wait(moving ? Math.max(1, (end - System.nanoTime()) / 1_000_000) : 0);
        } catch (InterruptedException e) {
          throw new IllegalStateException("nothing interrupts this thread", e);
        }
        moving = state == State.RENDERING && heard.isShown();
      }
      improved = false;
      return state;
    }
  }

  private Snapshot snapshot(State told) {
    Image image;
    String reason;
    Findings findings = null;
    synchronized (change) {
      if (renderer != null) {
        findings = new Findings(prepared, renderer.aovs(), Optional.ofNullable(statistics));
      }
      image = heard.isShown() ? renderer.image() : null;
      reason = message;
    }
    double seconds = watch.seconds();
    return new Snapshot(
        told,
        image == null ? marks.before() : Optional.of(picture(image)),
        Optional.ofNullable(image),
        told == State.DONE ? 1 : outlook.done(seconds),
        outlook.left(seconds),
        heard.rays(),
        seconds,
        heard.error(),
        Optional.ofNullable(findings),
        told.isOver() ? List.of() : marks.inWork(),
        reason);
  }

  private BufferedImage picture(Image image) {
    return marks.cover(Pictures.of(image, scene.transfer()));
  }

  private static Thread thread(String name, Runnable work) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    return thread;
  }
}
