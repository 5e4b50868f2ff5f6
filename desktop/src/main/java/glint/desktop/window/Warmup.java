package glint.desktop.window;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import glint.scene.World;

/**
 * A small render while the window is being opened, that has Java load and compile what the first
 * scene needs.
 */
final class Warmup {

  private static final int WIDTH = 48;
  private static final int HEIGHT = 36;
  private static final int BALLS = 40;

  private Warmup() {}

  /** Renders on a thread of its own; nothing comes of it but that the next is faster. */
  static void start() {
    Thread thread = new Thread(Warmup::render, "glint-window-warmup");
    thread.setDaemon(true);
    thread.start();
  }

  private static void render() {
    World world = new World(scene());
    Scene scene = world.scene();
    Pictures.everyNth(
        new Renderer(world.seenIn(scene), RenderSettings.of(scene)).render(Progress.NONE).image(),
        2,
        scene.transfer());
    Glimpse.of(world, scene, 1);
  }

  private static Scene scene() {
    Rgb half = Rgb.grey(0.5);
    Material shiny = new Material(half, half, half, 32, half, Rgb.BLACK);
    Medium medium = new Medium(1.5, Rgb.grey(0.1), 0);
    Material glass =
        new Material(Rgb.BLACK, Rgb.BLACK, half, 32, Rgb.BLACK, Rgb.BLACK, Rgb.WHITE, medium);
    Vector3d up = new Vector3d(0, 1, 0);
    Vector3d eye = new Vector3d(0, 2, 8);
    Scene.Builder scene = new Scene.Builder("warm-up");
    for (int i = 0; i < BALLS; i++) { // enough for a tree
      scene.place(Placement.of(new Sphere(new Vector3d(i - 20, 0.5, -3), 0.5), Material.WHITE));
    }
    return scene
        .size(WIDTH, HEIGHT)
        .camera(Camera.of(eye, up, up, Projection.vertical(40)))
        .light(new Light.Point(new Vector3d(3, 5, 4), Rgb.WHITE, false))
        .place(Placement.of(new Plane(Vector3d.ZERO, up), Material.WHITE))
        .place(Placement.of(new Sphere(new Vector3d(-1, 1, 0), 1), glass))
        .place(Placement.of(new Box(new Vector3d(1, 0, -1), new Vector3d(2, 2, 0)), shiny))
        .build();
  }
}
