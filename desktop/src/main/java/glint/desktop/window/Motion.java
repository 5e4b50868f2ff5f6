package glint.desktop.window;

import glint.scene.Camera;
import glint.scene.Scene;
import glint.scene.World;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;

/**
 * Renders a scene again and again on a thread of its own, by the newest camera, with so few pixels
 * that each picture is there in time.
 */
final class Motion {

  /** The time that a picture may take: with what else is to do, 15 a second are reached. */
  private static final double SECONDS = 0.04;

  /** A picture's first guess has so many times fewer columns and rows than the image. */
  private static final int COARSE = 8;

  /**
   * A picture, of as many pixels as there was time for; immutable.
   *
   * @param seconds the time that it took
   */
  record Frame(Camera camera, BufferedImage picture, double seconds) {}

  private final World world;
  private final Consumer<Frame> listener;
  private Camera next;
  private boolean over;
  private double secondsPerPixel;

  /**
   * Sets up; nothing runs before there is a camera.
   *
   * @param listener hears of every picture, on the thread that renders
   */
  Motion(World world, Consumer<Frame> listener) {
    this.world = world;
    this.listener = listener;
  }

  /** Begins. */
  void start() {
    Thread thread = new Thread(this::run, "glint-window-motion");
    thread.setDaemon(true);
    thread.start();
  }

  /** Shows what a camera sees soon, unless it is overtaken by another. */
  synchronized void show(Camera camera) {
    next = camera;
    notifyAll();
  }

  /** Ends soon. */
  synchronized void end() {
    over = true;
    notifyAll();
  }

  private void run() {
    for (Camera camera = await(); camera != null; camera = await()) {
      listener.accept(frame(camera));
    }
  }

  private synchronized Camera await() {
    while (next == null && !over) {
      try {
        wait();
      } catch (InterruptedException e) {
        throw new IllegalStateException("nothing interrupts this thread", e);
      }
    }
    Camera camera = over ? null : next;
    next = null;
    return camera;
  }

  private Frame frame(Camera camera) {
    long began = System.nanoTime();
    Scene scene = world.scene();
    Scene picture = scene.seenBy(camera, scene.width(), scene.height());
    BufferedImage shown = Glimpse.of(world, picture, fewer());
    double seconds = (System.nanoTime() - began) * 1e-9;
    secondsPerPixel = seconds / ((double) shown.getWidth() * shown.getHeight());
    return new Frame(camera, shown, seconds);
  }

  /** Returns how many times fewer columns and rows than the image a picture must have. */
  private int fewer() {
    if (secondsPerPixel == 0) {
      return COARSE;
    }
    double pixels = (double) world.scene().width() * world.scene().height();
    return Math.max(1, (int) Math.ceil(Math.sqrt(pixels * secondsPerPixel / SECONDS)));
  }
}
