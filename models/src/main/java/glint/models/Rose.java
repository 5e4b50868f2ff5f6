package glint.models;

import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.models.shape.Patch;
import glint.models.shape.Shape;
import glint.models.shape.Spline;
import glint.models.shape.Sweep;
import java.util.ArrayList;
import java.util.List;

/** A rose with its stem along −y; the origin is where the petals begin. Its width is about 1. */
final class Rose {

  private static final int PETALS = 19;
  private static final double GOLDEN_ANGLE = 2.39996;

  private Rose() {}

  static Model rose() {
    List<Shape> petals = new ArrayList<>();
    for (int i = 0; i < PETALS; i++) {
      petals.add(petal(i));
    }
    List<Vector3d> path =
        Spline.through(
            4,
            new Vector3d(0, 0.06, 0),
            new Vector3d(0.02, -0.5, 0.03),
            new Vector3d(-0.05, -1.1, 0.02),
            new Vector3d(0.03, -1.8, 0.06));
    Shape cup =
        Sweep.tube(
            Spline.through(3, at(0, -0.1, 0), at(0, 0.02, 0), at(0, 0.08, 0)),
            10,
            t -> 0.03 + 0.07 * t);
    Shape green = Sweep.tube(path, 7, t -> 0.03).plus(cup);
    for (int i = 0; i < 5; i++) {
      green = green.plus(turned(leaf(0.1, 0.34, 0.35), 72 * i).moved(0, 0.02, 0));
    }
    green = green.plus(turned(leaf(0.22, 0.62, 0.25), 40).moved(0.02, -0.62, 0.03));
    green = green.plus(turned(leaf(0.2, 0.55, 0.3), 190).moved(-0.03, -0.95, 0.02));
    return new Model()
        .add(Paint.dull("petals", 0.42, 0.012, 0.03).shiny(0.06, 12), Shape.of(petals))
        .add(Paint.dull("leaves", 0.05, 0.14, 0.04).shiny(0.1, 25), green);
  }

  /** Returns a petal that has fallen off, its hollow upwards. */
  static Model petal() {
    Shape petal =
        Patch.of(
            8,
            8,
            (u, v) -> {
              double across = 2 * u - 1;
              double width = 0.2 * outline(v);
              double rise = 0.1 * across * across * v + 0.14 * (v - 0.4) * (v - 0.4);
              return at(across * width, rise, 0.42 * (v - 0.5));
            });
    return Model.of(petal.reversed());
  }

  private static Shape petal(int number) {
    double open = StrictMath.pow((double) number / (PETALS - 1), 0.9);
    double turn = GOLDEN_ANGLE * number;
    double half = 1.5 - 0.75 * open;
    return Patch.of(
        8,
        8,
        (u, v) -> {
          double across = 2 * u - 1;
          double curl = Math.max(0, v - 0.7) / 0.3;
          double wave = 0.012 * StrictMath.sin(5 * across + number) * v;
          double radius =
              0.03
                  + (0.1 + 0.34 * open) * StrictMath.pow(v, 0.8 + 0.3 * open)
                  + (0.02 + 0.1 * open) * curl * curl
                  + 0.02 * across * across * open
                  + wave;
          double height =
              (0.5 - 0.16 * open) * v * (1 - 0.2 * StrictMath.pow(Math.abs(across), 3))
                  - 0.12 * open * curl * curl;
          double angle = turn + across * half * outline(v);
          return at(radius * StrictMath.sin(angle), height, radius * StrictMath.cos(angle));
        });
  }

  /** The width of a petal from its foot to its edge. */
  private static double outline(double v) {
    return 0.45 + 0.55 * Math.sqrt(Math.min(1, 1.8 * v)) * (1 - 0.35 * StrictMath.pow(v, 6));
  }

  private static Shape leaf(double halfWidth, double length, double droop) {
    return Patch.of(
        4,
        8,
        (u, v) -> {
          double across = 2 * u - 1;
          double width = halfWidth * StrictMath.sin(Math.PI * StrictMath.pow(v, 0.8));
          double y = 0.3 * length * Math.abs(across) * (1 - v) * v - droop * length * v * v;
          return at(across * width, y, length * v);
        });
  }

  private static Shape turned(Shape shape, double degrees) {
    return shape.moved(Transform.rotate(Quaternion.aboutAxis(at(0, 1, 0), degrees)));
  }

  private static Vector3d at(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }
}
