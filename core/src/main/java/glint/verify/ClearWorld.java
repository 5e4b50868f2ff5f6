package glint.verify;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Plane;
import glint.geometry.Pyramid;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Checker;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Stripes;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.List;

/**
 * Glass, smoke, bodies in bodies and patterns, with the eye in smoke and a near clipping plane, in
 * a world that may be scaled and mirrored in x.
 *
 * <p>All places are multiples of 1/64, so that powers of two change no bit.
 */
record ClearWorld(double scale, boolean mirrored, boolean parallel, Quaternion turn) {

  static final int WIDTH = 48;

  static final Quaternion TURN = Quaternion.aboutAxis(new Vector3d(1, 0, 0), 35);

  static ClearWorld plain(boolean parallel) {
    return new ClearWorld(1, false, parallel, TURN);
  }

  private Vector3d at(int x, int y, int z) {
    return new Vector3d(mirrored ? -x : x, y, z).times(scale / 64);
  }

  private Box box(Vector3d p, Vector3d q) {
    return mirrored
        ? new Box(new Vector3d(q.x(), p.y(), p.z()), new Vector3d(p.x(), q.y(), q.z()))
        : new Box(p, q);
  }

  private Placement clear(Surface surface, double ior, Rgb sigma, int priority) {
    return Placement.of(surface, material(Rgb.WHITE, ior, sigma, priority));
  }

  private Material material(Rgb transparency, double ior, Rgb sigma, int priority) {
    Medium inside = new Medium(ior, sigma.times(1 / scale), priority);
    return new Material(
        Rgb.BLACK, Rgb.BLACK, Rgb.grey(0.2), 30, Rgb.BLACK, Rgb.BLACK, transparency, inside);
  }

  Scene.Builder scene() {
    Rgb tint = new Rgb(0.2, 0.5, 1);
    Rgb odd = mirrored ? Rgb.WHITE : tint; // beyond x = 0 begins a cell of the other colour
    Rgb even = mirrored ? tint : Rgb.WHITE;
    Material floor = Material.WHITE.textured(new Checker(scale * 0.375, even, odd));
    Material layers = Material.WHITE.textured(new Stripes(scale * 0.3125, Rgb.WHITE, tint));
    Vector3d half = new Vector3d(20, 25, 30).times(scale / 64);
    Transform turned = Transform.rotate(turn).then(Transform.translate(at(-100, 10, 40)));
    return begin()
        .place(Placement.of(new Plane(at(0, -64, 0), new Vector3d(0, 1, 0)), floor))
        .place(new Placement(new Box(half.times(-1), half), turned, layers))
        .place(clear(new Sphere(at(19, 26, 0), scale * 0.875), 1.5, Rgb.grey(0.1), 0))
        .place(clear(new Sphere(at(19, 26, 0), scale * 0.5), 1.33, tint, 1))
        .place(clear(box(at(-90, -60, -64), at(-34, 6, 13)), 1.25, tint, 0))
        .place(
            clear(
                new Cylinder(at(115, -64, 64), at(128, 26, 51), scale * 0.375, 0, true),
                1.6,
                tint,
                2))
        .place(clear(pyramid(), 1.4, Rgb.BLACK, 0))
        .place(clear(new Sphere(at(20, 40, 256), scale), 1, tint, 0))
        .place(Placement.of(pane(), material(tint, 1, Rgb.BLACK, 0)));
  }

  private Surface pane() {
    return new Quad(at(-150, -60, 70), at(128, 19, 0), at(13, 96, 26));
  }

  private Surface pyramid() {
    List<Vector3d> base =
        List.of(at(30, -64, 100), at(70, -64, 90), at(80, -64, 140), at(28, -64, 135));
    return new Pyramid(at(55, 0, 110), base);
  }

  private Scene.Builder begin() {
    Projection lens = parallel ? new Orthographic(scale * 4) : Projection.vertical(50);
    Camera camera =
        new Camera(
            at(32, 60, 270),
            at(6, 13, 19),
            new Vector3d(0, 1, 0),
            lens,
            scale * 0.25,
            Double.POSITIVE_INFINITY);
    return new Scene.Builder("clear")
        .size(WIDTH, 32)
        .camera(camera)
        .background(new Background(Rgb.grey(0.2), new Rgb(0.3, 0.4, 0.9)))
        .light(new Light.Ambient(Rgb.grey(0.1)))
        .light(new Light.Point(at(192, 384, 256), Rgb.grey(9 * scale * scale), true))
        .light(new Light.Directional(at(-13, -64, -26), Rgb.grey(0.5)));
  }
}
