package glint.models;

import glint.math.Vector3d;
import glint.models.shape.Noise;
import glint.models.shape.Patch;
import glint.models.shape.Shape;
import glint.models.shape.Superellipsoid;
import glint.models.shape.Sweep;
import java.util.ArrayList;
import java.util.List;

/** A slab of stone, and a wall of stones with a pointed window. */
final class Crypt {

  private static final Noise NOISE = new Noise(7);
  private static final double HALF_WINDOW = 0.8;
  private static final double SPRING = 2.4;

  private Crypt() {}

  /** Returns the slab: 8 × 0.7 × 5, its top at about y = 0. */
  static Model slab() {
    Shape block = Superellipsoid.of(new Vector3d(4, 0.35, 2.5), 0.12, 72, 16);
    return Model.of(
        block.mapped(
            p -> {
              double worn = 0.03 * NOISE.octaves(p.times(1.7), 3);
              double edge = Math.abs(p.y()) > 0.34 ? 0.35 : 1.6;
              return p.plus(new Vector3d(worn * edge, 0.35 * worn - 0.35, worn * edge));
            }));
  }

  /** Returns the wall in the plane z = 0, from the ground up, the window in its middle. */
  static Model wall() {
    List<Shape> stones = new ArrayList<>();
    for (int row = 0; row < 9; row++) {
      for (int column = -6; column <= 5; column++) {
        double x = column + (row % 2 == 0 ? 0.5 : 0);
        double y = 0.27 + 0.54 * row;
        if (!inWindow(x, y, 0.35)) {
          stones.add(stone(x, y, 100L * row + column));
        }
      }
    }
    return new Model()
        .add(Paint.dull("stone", 0.2, 0.19, 0.19), Shape.of(stones))
        .add(Paint.dull("frame", 0.16, 0.15, 0.15), frame())
        .add(Paint.dull("pane", 0, 0, 0).glowing(0.1, 0.2, 0.42), pane());
  }

  private static Shape stone(double x, double y, long number) {
    Vector3d half =
        new Vector3d(0.485 + 0.01 * NOISE.pick(number), 0.262, 0.25 + 0.06 * NOISE.pick(-number));
    return Superellipsoid.of(half, 0.14, 8, 4)
        .mapped(
            p -> {
              Vector3d q = p.plus(new Vector3d(x, y, 0));
              return q.plus(new Vector3d(0, 0.3, 1).times(0.04 * NOISE.at(q.times(2.3))));
            });
  }

  /** Returns whether a point is in the window or at most so far beside it. */
  private static boolean inWindow(double x, double y, double beside) {
    double reach = HALF_WINDOW + beside;
    if (y < 1.0 - beside || Math.abs(x) > reach) {
      return false;
    }
    double away = Math.abs(x) + HALF_WINDOW;
    double up = y - SPRING;
    return up < 0 || away * away + up * up < (HALF_WINDOW + reach) * (HALF_WINDOW + reach);
  }

  /** The half width of the window at a height: each arc is a circle around the other side. */
  private static double halfWidth(double y) {
    double up = Math.max(0, y - SPRING);
    return Math.sqrt(Math.max(0, 4 * HALF_WINDOW * HALF_WINDOW - up * up)) - HALF_WINDOW;
  }

  private static Shape pane() {
    double top = SPRING + HALF_WINDOW * Math.sqrt(3);
    return Patch.of(
        2,
        24,
        (u, v) -> {
          double y = 1 + (top - 1) * v;
          return new Vector3d((2 * u - 1) * halfWidth(y), y, -0.1);
        });
  }

  private static Shape frame() {
    List<Vector3d> side = new ArrayList<>();
    double top = SPRING + HALF_WINDOW * Math.sqrt(3);
    for (int i = 0; i <= 28; i++) {
      double y = 1 + (top - 1) * i / 28;
      side.add(new Vector3d(halfWidth(y) + 0.04, y, 0.12));
    }
    Shape arcs = Sweep.tube(side, 8, t -> 0.13).withMirrorImage();
    List<Vector3d> middle = List.of(new Vector3d(0, 1, 0), new Vector3d(0, SPRING + 0.9, 0));
    List<Shape> bars = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      double y = 1.45 + 0.45 * i;
      bars.add(
          Sweep.tube(List.of(new Vector3d(-0.8, y, 0), new Vector3d(0.8, y, 0)), 6, t -> 0.025));
    }
    return arcs.plus(Sweep.tube(middle, 8, t -> 0.05)).plus(Shape.of(bars));
  }
}
