package glint.models;

import glint.math.Vector3d;
import glint.models.shape.Lathe;
import glint.models.shape.Noise;
import glint.models.shape.Patch;
import glint.models.shape.Shape;
import glint.models.shape.Spline;
import glint.models.shape.Superellipsoid;
import glint.models.shape.Sweep;
import java.util.ArrayList;
import java.util.List;

/** A street in the rain at night: the road, a house front, a lamp and falling drops. */
final class Street {

  private static final Noise NOISE = new Noise(11);
  private static final double FLOOR = 3.1;

  /** What stands behind the windows, in turn by chance; most are dark. */
  private static final Paint[] ROOMS = {
    Paint.dull("room-dark", 0.006, 0.008, 0.012).mirror(0.1, 0.1, 0.12, 200),
    Paint.dull("room-warm", 0, 0, 0).glowing(0.55, 0.3, 0.1),
    Paint.dull("room-amber", 0, 0, 0).glowing(0.3, 0.13, 0.03),
    Paint.dull("room-blue", 0, 0, 0).glowing(0.06, 0.13, 0.24)
  };

  private static final int[] CHANCES = {0, 0, 0, 1, 0, 2, 0, 3, 2, 0};

  private Street() {}

  /** Returns the road: uneven, so that water stands in its hollows up to y = 0. */
  static Model road() {
    Shape road =
        Patch.of(
            72,
            30,
            (u, v) -> {
              // Denser towards the middle, where the camera looks
              double x = 34 * u - 14 + 3 * StrictMath.sin(2 * Math.PI * u);
              double z = 8.5 - 13 * v;
              Vector3d p = new Vector3d(x, 0, z);
              double y = 0.02 * NOISE.octaves(p.times(0.45), 3) + 0.004 * NOISE.at(p.times(5));
              return new Vector3d(x, y + 0.002, z);
            });
    return Model.of(road);
  }

  /**
   * Returns the front of a house: 12 wide from x = 0, four floors from y = 0, in the plane z = 0.
   */
  static Model house() {
    Model model = new Model();
    List<Shape> wall = new ArrayList<>();
    List<Shape> frames = new ArrayList<>();
    wall.add(rectangle(0, 0, 12, 4 * FLOOR + 1, -0.15));
    for (int floor = 1; floor < 4; floor++) {
      for (int column = 0; column < 6; column++) {
        double x = 0.5 + 1.95 * column;
        double y = 0.9 + FLOOR * floor;
        int room = CHANCES[(int) (10 * NOISE.pick(31L * floor + column))];
        model.add(ROOMS[room], rectangle(x, y, 1.2, 1.7, -0.1));
        frames.add(box(x + 0.6, y - 0.06, 0.05, 0.75, 0.06, 0.14));
        frames.add(box(x + 0.6, y + 1.76, 0, 0.7, 0.06, 0.08));
        frames.add(box(x + 0.6, y + 0.85, -0.05, 0.03, 0.85, 0.05));
      }
      frames.add(box(6, FLOOR * floor + 0.25, 0, 6, 0.1, 0.16));
    }
    for (int shop = 0; shop < 3; shop++) {
      double x = 0.4 + 3.9 * shop;
      Paint light =
          shop == 1
              ? Paint.dull("shop-teal", 0, 0, 0).glowing(0.1, 0.34, 0.36)
              : Paint.dull("shop-warm", 0, 0, 0).glowing(0.7, 0.42, 0.17);
      model.add(light, rectangle(x, 0.7, 2.2, 1.9, -0.1));
      model.add(ROOMS[0], rectangle(x + 2.4, 0.1, 0.9, 2.4, -0.1));
      frames.add(box(x + 1.1, 0.4, 0, 1.15, 0.3, 0.06));
      frames.add(box(x + 1.1, 1.65, -0.05, 0.03, 0.95, 0.05));
      frames.add(box(x + 1.65, 2.8, 0.35, 1.75, 0.09, 0.5));
    }
    return model
        .add(Paint.dull("wall", 0.09, 0.075, 0.07), Shape.of(wall))
        .add(Paint.dull("frame", 0.06, 0.055, 0.055), Shape.of(frames));
  }

  private static Shape rectangle(double x, double y, double width, double height, double z) {
    return Patch.of(1, 1, (u, v) -> new Vector3d(x + width * u, y + height * v, z));
  }

  private static Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return Superellipsoid.of(new Vector3d(dx, dy, dz), 0.1, 4, 3).moved(x, y, z);
  }

  /** Returns a street lamp, 5.2 high at the origin, its arm along z to 1.5. */
  static Model lamp() {
    Shape foot = Lathe.body(12, 0, 0, .2, 0, .2, .1, .13, .2, .11, .9, .07, 1.0, .06, 1.1, 0, 1.1);
    List<Vector3d> arm =
        Spline.through(
            5,
            new Vector3d(0, 1, 0),
            new Vector3d(0, 3, 0),
            new Vector3d(0, 4.6, 0),
            new Vector3d(0, 5.2, 0.45),
            new Vector3d(0, 5.3, 1.1),
            new Vector3d(0, 5.28, 1.3));
    Shape hood = Lathe.tube(16, .26, 0, .25, .06, .14, .16, .07, .2).moved(0, 5.12, 1.42);
    Shape bulb = Lathe.body(12, 0, -.08, .1, -.06, .15, 0, .1, .06, 0, .08).moved(0, 5.13, 1.42);
    return new Model()
        .add(
            Paint.dull("iron", 0.02, 0.022, 0.024).shiny(0.3, 60),
            foot.plus(Sweep.tube(arm, 8, t -> 0.06 - 0.025 * t)).plus(hood))
        .add(Paint.dull("bulb", 0, 0, 0).glowing(1.3, 0.95, 0.55), bulb);
  }

  /** Returns a sign of glowing tubes that reads HOTEL downwards; letters are 0.5 wide. */
  static Model sign() {
    double[][][] letters = {
      {{0, 0, 0, 1}, {1, 0, 1, 1}, {0, .5, 1, .5}},
      {{.3, 0, 0, .3, 0, .7, .3, 1, .7, 1, 1, .7, 1, .3, .7, 0, .3, 0}},
      {{.5, 0, .5, 1}, {0, 1, 1, 1}},
      {{1, 0, 0, 0, 0, 1, 1, 1}, {0, .5, .8, .5}},
      {{0, 1, 0, 0, 1, 0}}
    };
    List<Shape> tubes = new ArrayList<>();
    for (int i = 0; i < letters.length; i++) {
      for (double[] stroke : letters[i]) {
        for (int k = 0; k + 3 < stroke.length; k += 2) {
          tubes.add(
              stroke(stroke[k], stroke[k + 1] - 1.45 * i, stroke[k + 2], stroke[k + 3] - 1.45 * i));
        }
      }
    }
    return new Model()
        .add(Paint.dull("neon", 0, 0, 0).glowing(1.1, 0.1, 0.42), Shape.of(tubes))
        .add(
            Paint.dull("board", 0.012, 0.01, 0.014),
            Superellipsoid.of(new Vector3d(0.42, 1.95, 0.05), 0.2, 12, 8).moved(0.25, -1.2, -0.1));
  }

  private static Shape stroke(double x1, double y1, double x2, double y2) {
    return Sweep.tube(
        List.of(new Vector3d(x1 / 2, y1 / 2, 0), new Vector3d(x2 / 2, y2 / 2, 0)), 6, t -> 0.035);
  }

  /** Returns drops in a box of 12 × 7 × 8, blurred to streaks as the eye sees them. */
  static Model rain() {
    List<Shape> drops = new ArrayList<>();
    for (int i = 0; i < 190; i++) {
      double x = 12 * NOISE.pick(3L * i + 1);
      double y = 7 * NOISE.pick(3L * i + 2);
      double z = 8 * NOISE.pick(3L * i + 3);
      double length = 0.25 + 0.3 * NOISE.pick(-i);
      Vector3d fall = new Vector3d(0.14, -1, 0.03).times(length);
      Vector3d top = new Vector3d(x, y, z);
      Vector3d middle = top.plus(fall.times(0.7));
      drops.add(drop(top, middle, top.plus(fall)));
    }
    return Model.of(Shape.of(drops));
  }

  private static Shape drop(Vector3d top, Vector3d middle, Vector3d end) {
    List<Vector3d> points = new ArrayList<>(List.of(end));
    for (int i = 0; i < 3; i++) {
      double angle = 2 * Math.PI * i / 3;
      points.add(
          middle.plus(new Vector3d(StrictMath.sin(angle), 0, StrictMath.cos(angle)).times(0.006)));
    }
    points.add(top);
    List<int[]> faces = new ArrayList<>();
    for (int i = 1; i <= 3; i++) {
      int next = i % 3 + 1;
      faces.add(new int[] {0, next, i});
      faces.add(new int[] {i, next, 4});
    }
    return new Shape(points, faces);
  }
}
