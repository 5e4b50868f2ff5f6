package glint.models;

import glint.color.Rgb;
import glint.math.Vector3d;
import glint.models.shape.Lathe;
import glint.models.shape.Loft;
import glint.models.shape.Noise;
import glint.models.shape.Shape;
import glint.models.shape.Superellipsoid;
import java.util.ArrayList;
import java.util.List;

/** What is around the astronaut: stars, a planet with bands of clouds, and rocks. */
final class Space {

  private static final Noise NOISE = new Noise(5);
  private static final int ROWS = 34;
  private static final int SEGMENTS = 68;

  private Space() {}

  /** Returns the planet, of radius 1, its axis along y: rows of clouds with uneven borders. */
  static Model planet() {
    List<List<Vector3d>> rows = new ArrayList<>();
    for (int i = 0; i <= ROWS; i++) {
      rows.add(border(i));
    }
    Model model = new Model();
    for (int i = 0; i < ROWS; i++) {
      Paint paint = clouds(i);
      model.add(paint, Loft.tube(rows.subList(i, i + 2)));
    }
    return model;
  }

  private static List<Vector3d> border(int number) {
    double latitude = Math.PI * ((number + 0.02) / (ROWS + 0.04) - 0.5);
    List<Vector3d> ring = new ArrayList<>();
    for (Vector3d p : Lathe.ring(SEGMENTS, 1, 0)) {
      Vector3d place = new Vector3d(2.5 * p.x(), 9 * latitude, 2.5 * p.z());
      double swirl = 0.022 * StrictMath.cos(latitude) * NOISE.octaves(place, 2);
      double y = StrictMath.sin(latitude + swirl);
      double r = StrictMath.cos(latitude + swirl);
      ring.add(new Vector3d(p.x() * r, y, p.z() * r));
    }
    return ring;
  }

  private static Paint clouds(int row) {
    double share = (row + 0.5) / ROWS;
    double tone = 0.52 + 0.75 * NOISE.octaves(new Vector3d(9 * share, 0.5, 0.5), 3);
    double t = Math.max(0, Math.min(1, tone));
    Rgb dark = new Rgb(0.3, 0.11, 0.05);
    Rgb pale = new Rgb(0.82, 0.58, 0.33);
    double pole = StrictMath.pow(Math.abs(2 * share - 1), 3);
    return Paint.dull(
        "clouds" + row,
        mix(mix(dark.r(), pale.r(), t), 0.26, pole),
        mix(mix(dark.g(), pale.g(), t), 0.3, pole),
        mix(mix(dark.b(), pale.b(), t), 0.36, pole));
  }

  private static double mix(double a, double b, double share) {
    return a + (b - a) * share;
  }

  /** Returns 250 stars before −z, 100 away from the eye at the origin, 0.1 to 0.2 wide. */
  static Model stars() {
    Paint[] paints = {
      Paint.dull("faint", 0, 0, 0).glowing(0.22, 0.24, 0.3),
      Paint.dull("blue", 0, 0, 0).glowing(0.5, 0.65, 1),
      Paint.dull("amber", 0, 0, 0).glowing(0.8, 0.55, 0.3),
      Paint.dull("bright", 0, 0, 0).glowing(1, 1, 1)
    };
    Model model = new Model();
    for (int i = 0; i < 250; i++) {
      double x = 130 * (NOISE.pick(4L * i) - 0.5);
      double y = 100 * (NOISE.pick(4L * i + 1) - 0.5);
      Vector3d center = new Vector3d(x, y, -70).normalized().times(100);
      double size = NOISE.pick(4L * i + 2);
      int kind = size < 0.6 ? 0 : 1 + (int) (3 * NOISE.pick(4L * i + 3));
      model.add(paints[kind], star(center, 0.07 + 0.09 * size * size * size));
    }
    return model;
  }

  private static Shape star(Vector3d center, double radius) {
    Vector3d view = center.normalized();
    Vector3d right = view.cross(new Vector3d(0, 1, 0)).normalized();
    Vector3d up = right.cross(view);
    List<Vector3d> corners = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      double angle = Math.PI * i / 3;
      Vector3d out = right.times(StrictMath.cos(angle)).plus(up.times(StrictMath.sin(angle)));
      corners.add(center.plus(out.times(radius)));
    }
    return new Shape(corners, List.of(new int[] {0, 1, 2, 3, 4, 5}));
  }

  /** Returns a rock of about radius 1. */
  static Model rock() {
    Shape ball = Superellipsoid.of(new Vector3d(1, 0.75, 0.85), 0.9, 20, 14);
    return Model.of(ball.mapped(p -> p.times(1 + 0.22 * NOISE.octaves(p.times(1.6), 3))));
  }
}
