package glint.models;

import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.models.shape.Lathe;
import glint.models.shape.Shape;
import glint.models.shape.Superellipsoid;

/**
 * A space ship, 8 long, which flies along z; its engines end at z = −4, what they throw out at −7.
 */
final class Ship {

  private Ship() {}

  static Model model() {
    Paint hull = Paint.dull("hull", 0.5, 0.51, 0.53).shiny(0.4, 60);
    Paint dark = Paint.dull("dark", 0.09, 0.1, 0.11).shiny(0.3, 40);
    Paint panel = Paint.dull("panel", 0.02, 0.035, 0.09).mirror(0.2, 0.22, 0.3, 150);
    Paint glow = Paint.dull("glow", 0, 0, 0).glowing(0.85, 1.25, 1.7);
    Paint plume = Paint.dull("plume", 0, 0, 0).glowing(0.09, 0.16, 0.28).covering(0.1);
    Paint window = Paint.dull("window", 0, 0, 0).glowing(1.1, 0.8, 0.4);
    Shape body =
        Lathe.body(
            24, 0, -3.2, .55, -3.2, .75, -2.9, .75, -1.4, .6, -1.2, .6, -.9, .95, -.6, .95, 1.4, .8,
            1.7, .55, 2.0, .5, 2.9, .62, 3.0, .6, 3.5, .3, 3.9, 0, 4);
    Model model = new Model().add(hull, alongZ(body));
    for (int i = 0; i < 3; i++) {
      double degrees = 120 * i + 90;
      Shape nozzle = Lathe.tube(16, .34, -4, .3, -3.6, .18, -3.2, .14, -3.0, .3, -2.9, .3, -3.1);
      Shape fire = Lathe.body(16, 0, -3.75, .26, -3.7, .2, -3.4, 0, -3.3);
      model.add(dark, around(alongZ(nozzle).moved(0, 0.5, 0), degrees));
      model.add(glow, around(alongZ(fire).moved(0, 0.5, 0), degrees));
      for (double size : new double[] {0.3, 0.2, 0.12}) {
        Shape cone = Lathe.tube(16, 0.02, -4 - 11 * size, size, -4);
        model.add(plume, around(alongZ(cone).moved(0, 0.5, 0), degrees));
      }
    }
    for (int side = 0; side < 2; side++) {
      model.add(panel, around(box(2.4, 0, 0.3, 1.3, 0.03, 0.7), 180 * side));
      model.add(dark, around(box(1.1, 0, 0.3, 0.3, 0.08, 0.12), 180 * side));
    }
    model.add(dark, alongZ(Lathe.tube(24, .97, -.3, 1.0, -.25, 1.0, .0, .97, .05)));
    for (int i = 0; i < 10; i++) {
      model.add(window, around(box(0, 0.95, 0.7, 0.07, 0.03, 0.1), 36 * i + 18));
    }
    return model;
  }

  /** Turns the y axis to z. */
  private static Shape alongZ(Shape shape) {
    return shape.moved(Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 0, 0), 90)));
  }

  private static Shape around(Shape shape, double degrees) {
    return shape.moved(Transform.rotate(Quaternion.aboutAxis(new Vector3d(0, 0, 1), degrees)));
  }

  private static Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return Superellipsoid.of(new Vector3d(dx, dy, dz), 0.2, 12, 6).moved(x, y, z);
  }
}
