package glint.desktop.window;

import glint.math.BadValueException;
import glint.render.RenderSettings;
import glint.render.Replay;
import glint.scene.Camera;
import glint.scene.Handheld;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.scene.World;
import glint.trace.RayTree;
import java.awt.Point;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/**
 * What is rendered: one scene, seen by a camera that is moved by hand; belongs to the event thread.
 *
 * <p>While the camera moves there are pictures of few pixels; when it rests, a render.
 */
final class Stage {

  /** So long after its last move a camera rests. */
  private static final int REST_MILLIS = 200;

  private final Consumer<Snapshot> listener;
  private final Timer rest = new Timer(REST_MILLIS, e -> rest());
  private Picked picked;
  private World world;
  private Camera camera;
  private RenderRun run;
  private Motion motion;
  private Motion.Frame frame;
  private boolean resting;
  private boolean stopping;

  /**
   * Makes an empty one.
   *
   * @param listener hears, on the event thread, of every change
   */
  Stage(Consumer<Snapshot> listener) {
    this.listener = listener;
    rest.setRepeats(false);
  }

  /**
   * Renders a scene instead of the one before. A new version of that is seen by the camera as it
   * was moved, unless its own has changed.
   */
  void show(Picked next) {
    close();
    boolean keeps =
        picked != null
            && picked.isVersionOf(next)
            && picked.scene().camera().equals(next.scene().camera());
    camera = keeps ? camera : next.scene().camera();
    picked = next;
    world = new World(next.scene());
    render(Optional.empty());
  }

  /** Returns the camera, or nothing while there is no scene. */
  Optional<Camera> camera() {
    return Optional.ofNullable(camera);
  }

  /** Returns the camera as one to be moved in the scene's image; only if there is a scene. */
  Handheld held() {
    return new Handheld(camera, world.scene().width(), world.scene().height());
  }

  /** Moves the camera, if there is a scene and the camera can go there. */
  void move(Function<Handheld, Camera> by) {
    if (camera != null) {
      try {
        moveTo(by.apply(held()));
      } catch (BadValueException e) {
        return; // out of the range of coordinates
      }
    }
  }

  /** Moves the camera back to where the scene has it. */
  void reset() {
    move(held -> world.scene().camera());
  }

  /** Makes what a pixel shows the camera's target, soon. */
  void aim(Point pixel) {
    look(
        pixel,
        rays -> {
          Optional<RayTree.Meeting> met = rays.sample().tree().met();
          met.ifPresent(it -> move(held -> held.aimed(it.point())));
        });
  }

  /** Traces the ray through the middle of a pixel; not heard of if the camera moves meanwhile. */
  void look(Point pixel, Consumer<PixelRays> heard) {
    Scene picture = picture();
    World own = world;
    Camera by = camera;
    Thread thread =
        new Thread(
            () -> {
              Prepared scene = own.seenIn(picture);
              RenderSettings one = RenderSettings.of(picture).sampled(1, 0);
              Replay.Sample sample = new Replay(scene, one, pixel.x, pixel.y).sample(0);
              SwingUtilities.invokeLater(
                  () -> {
                    if (world.equals(own) && camera.equals(by)) {
                      heard.accept(new PixelRays(scene, pixel, sample));
                    }
                  });
            },
            "glint-window-look");
    thread.setDaemon(true);
    thread.start();
  }

  private Scene picture() {
    Scene own = world.scene();
    return camera.equals(own.camera()) ? own : own.seenBy(camera, own.width(), own.height());
  }

  private void moveTo(Camera next) {
    if (next.equals(camera)) {
      return;
    }
    camera = next;
    leave();
    resting = false;
    stopping = false;
    if (motion == null) {
      Motion[] own = new Motion[1];
      own[0] = new Motion(world, new Latest<>(shown -> show(own[0], shown)));
      motion = own[0];
      motion.start();
    }
    motion.show(camera);
    rest.restart();
  }

  private void show(Motion from, Motion.Frame shown) {
    if (from == motion && run == null) {
      frame = shown;
      listener.accept(Snapshot.moving(shown));
      if (resting) {
        rest();
      }
    }
  }

  /** Renders as soon as the newest camera's picture is there, if the camera has moved. */
  void rest() {
    rest.stop();
    resting = run == null && motion != null;
    if (resting && frame != null && frame.camera().equals(camera)) {
      resting = false;
      render(Optional.of(frame.picture()));
    }
  }

  private void render(Optional<BufferedImage> before) {
    RenderRun[] next = new RenderRun[1];
    Latest<Snapshot> latest =
        new Latest<>(
            snapshot -> {
              if (next[0] == run) {
                listener.accept(snapshot);
              }
            });
    next[0] = new RenderRun(world, picture(), before, latest);
    run = next[0];
    listener.accept(Snapshot.preparing());
    run.start();
    if (stopping) {
      run.stop();
    }
  }

  /** Has the render wait, or go on. */
  void pause(boolean wait) {
    if (run != null) {
      run.pause(wait);
    }
  }

  /** Ends the render, or that which would follow when the camera rests; what is shown stays. */
  void stop() {
    if (run != null) {
      run.stop();
    } else if (motion != null) {
      stopping = true;
      rest();
    }
  }

  /** Ends the render, of which nothing more is heard. */
  private void leave() {
    if (run != null) {
      run.stop();
      run = null;
    }
  }

  /** Ends all that runs. */
  void close() {
    leave();
    rest.stop();
    stopping = false;
    if (motion != null) {
      motion.end();
      motion = null;
      frame = null;
    }
  }

  /** Ends all that runs and forgets it: whoever still knows the window keeps no image. */
  void end() {
    close();
    picked = null;
    world = null;
    camera = null;
  }
}
