package glint.verify;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Plane;
import glint.geometry.Pyramid;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.light.Light;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.List;

/**
 * One of every surface and light, in a world that may be scaled, mirrored in x, and moved.
 *
 * <p>All places are multiples of 1/64, so that powers of two and dyadic moves change no bit.
 */
record SampleWorld(double scale, boolean mirrored, Vector3d offset, Material material) {

  /** Diffuse with a highlight, and a mirror. */
  static final Material GLOSSY =
      new Material(
          Rgb.grey(0.1), new Rgb(0.2, 0.3, 0.4), Rgb.grey(0.5), 40, Rgb.grey(0.6), Rgb.BLACK);

  /** The same, but no mirror. */
  static final Material DULL =
      new Material(Rgb.grey(0.1), new Rgb(0.2, 0.3, 0.4), Rgb.grey(0.5), 40, Rgb.BLACK, Rgb.BLACK);

  static final SampleWorld PLAIN = new SampleWorld(1, false, Vector3d.ZERO, GLOSSY);

  static SampleWorld scaled(double scale) {
    return new SampleWorld(scale, false, Vector3d.ZERO, GLOSSY);
  }

  /** A place, given in 64ths. */
  private Vector3d at(int x, int y, int z) {
    return along(x, y, z).times(scale / 64).plus(offset);
  }

  private Vector3d along(double x, double y, double z) {
    return new Vector3d(mirrored ? -x : x, y, z);
  }

  private Vector3d edge(int x, int y, int z) {
    return along(x, y, z).times(scale / 64);
  }

  private Box box() {
    Vector3d p = at(-256, -64, -64);
    Vector3d q = at(-154, 6, 13);
    return mirrored
        ? new Box(new Vector3d(q.x(), p.y(), p.z()), new Vector3d(p.x(), q.y(), q.z()))
        : new Box(p, q);
  }

  private List<Surface> surfaces() {
    return List.of(
        new Plane(at(0, -64, 0), along(0.125, 1, 0)),
        new Sphere(at(19, 26, 0), scale * 0.875),
        new Triangle(at(-192, -64, -64), at(-64, 160, -96), at(-32, -64, 0)),
        new Quad(at(96, -64, -128), edge(128, 19, 0), edge(13, 128, 26)),
        box(),
        new Pyramid(
            at(-64, 19, 128),
            List.of(at(-128, -64, 64), at(-19, -64, 64), at(0, -64, 172), at(-128, -64, 192))),
        new Cylinder(at(115, -64, 64), at(128, 26, 51), scale * 0.375, scale * 0.1875, true),
        new Cylinder(at(38, -58, 160), at(60, -10, 160), scale * 0.25, scale * 0.25, false));
  }

  Scene.Builder scene() {
    Projection lens = Projection.vertical(50);
    Scene.Builder scene =
        new Scene.Builder("world")
            .size(48, 32)
            .camera(Camera.of(at(32, 96, 512), at(6, 13, 19), along(0, 1, 0), lens))
            .background(new Background(Rgb.grey(0.1), new Rgb(0.3, 0.4, 0.9)))
            .light(new Light.Ambient(Rgb.grey(0.2)))
            .light(new Light.Point(at(192, 384, 256), Rgb.grey(0.5), false))
            .light(new Light.Point(at(-192, 256, 192), Rgb.grey(9 * scale * scale), true))
            .light(new Light.Directional(along(-0.2, -1, -0.4), Rgb.grey(0.2)));
    for (Surface surface : surfaces()) {
      scene.place(Placement.of(surface, surface instanceof Box ? Material.WHITE : material));
    }
    Transform squash =
        Transform.scale(new Vector3d(1, 0.5, 0.25)).then(Transform.translate(at(32, -26, 160)));
    return scene.place(new Placement(new Sphere(Vector3d.ZERO, scale * 0.625), squash, material));
  }
}
