package glint.report;

import glint.color.Rgb;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Quad;
import glint.geometry.Surface;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;

/**
 * Counts what renders to an error miss without a word: pixels that a bright line crosses, which is
 * thinner than they are, and none of whose rays has met it.
 *
 * <p>Lines of every direction are made as quads, as cylinders and as meshes of two triangles, each
 * in an image of its own, rendered to one level.
 */
public final class ThinLines {

  /**
   * What was counted.
   *
   * @param width of the lines, in pixels
   * @param crossed pixels that a line's axis crosses
   * @param missed those of them that show nothing of it
   */
  public record Count(double width, int crossed, int missed) {}

  /** The error that is asked for, in levels. */
  private static final double TARGET = 1;

  /** Lines of each kind. */
  private static final int LINES = 20;

  private static final int COLUMNS = 80;
  private static final int ROWS = 60;

  /** What crosses less than this length of a pixel, in pixels, is a corner that it touches. */
  private static final double TOUCHED = 1e-3;

  private ThinLines() {}

  /** Counts for lines so wide, in pixels. */
  public static Count count(double width) {
    Random random = new Random(7);
    int crossed = 0;
    int missed = 0;
    for (int i = 0; i < 3 * LINES; i++) {
      double turn = 2 * Math.PI * random.nextDouble();
      double length = 20 + 20 * random.nextDouble();
      Vector3d middle =
          new Vector3d(
              20 + (COLUMNS - 40) * random.nextDouble(), 20 + (ROWS - 40) * random.nextDouble(), 0);
      Vector3d half = new Vector3d(StrictMath.cos(turn), StrictMath.sin(turn), 0).times(length / 2);
      Vector3d a = middle.minus(half);
      Vector3d b = middle.plus(half);
      double[] rgb = render(line(i % 3, a, b, width), i);
      for (int pixel = 0; pixel < COLUMNS * ROWS; pixel++) {
        int y = pixel / COLUMNS;
        if (within(a, b, pixel % COLUMNS, ROWS - 1 - y) > TOUCHED) {
          crossed++;
          missed += rgb[3 * pixel] == 0 ? 1 : 0;
        }
      }
    }
    return new Count(width, crossed, missed);
  }

  private static double[] render(Surface line, long seed) {
    Vector3d centre = new Vector3d(COLUMNS / 2.0, ROWS / 2.0, 0);
    Rgb black = Rgb.BLACK;
    Scene scene =
        new Scene.Builder("line")
            .size(COLUMNS, ROWS)
            .camera(
                Camera.of(
                    centre.plus(new Vector3d(0, 0, 100)),
                    centre,
                    new Vector3d(0, 1, 0),
                    new Orthographic(ROWS)))
            .background(Background.constant(black))
            .place(Placement.of(line, new Material(black, black, black, 1, black, Rgb.WHITE)))
            .build();
    RenderSettings settings =
        new RenderSettings(
            COLUMNS, ROWS, new Goal.Error(TARGET), seed, OptionalInt.empty(), 1, 32, Set.of());
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE).image().rgb();
  }

  private static Surface line(int kind, Vector3d a, Vector3d b, double width) {
    Vector3d along = b.minus(a);
    Vector3d across = new Vector3d(-along.y(), along.x(), 0).normalized().times(width);
    Vector3d corner = a.minus(across.times(0.5));
    if (kind == 0) {
      return new Quad(corner, along, across);
    }
    if (kind == 1) {
      return new Cylinder(a, b, width / 2, width / 2, true);
    }
    Vector3d[] corners = {
      corner, corner.plus(along), corner.plus(along).plus(across), corner.plus(across)
    };
    double[] points = new double[12];
    for (int i = 0; i < 4; i++) {
      points[3 * i] = corners[i].x();
      points[3 * i + 1] = corners[i].y();
    }
    return new Mesh(points, new int[] {0, 1, 2, 0, 2, 3});
  }

  /** Returns the length of the part of a line within a unit square (Liang and Barsky 1984). */
  private static double within(Vector3d a, Vector3d b, double left, double low) {
    Vector3d along = b.minus(a);
    double[] from = {(left - a.x()) / along.x(), (low - a.y()) / along.y()};
    double[] to = {(left + 1 - a.x()) / along.x(), (low + 1 - a.y()) / along.y()};
    double enters = 0;
    double leaves = 1;
    for (int i = 0; i < 2; i++) {
      enters = Math.max(enters, Math.min(from[i], to[i]));
      leaves = Math.min(leaves, Math.max(from[i], to[i]));
    }
    return Math.max(0, leaves - enters) * along.length();
  }
}
