package glint.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Pyramid;
import glint.geometry.Quad;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Checker;
import glint.optics.Material;
import glint.optics.Pattern;
import glint.optics.Stripes;
import glint.optics.Texture;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.List;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Which colour of a pattern is seen where. */
class TextureTest {

  private static final Checker CHECKER = new Checker(0.5, Rgb.BLACK, Rgb.WHITE);
  private static final Stripes STRIPES = new Stripes(0.5, Rgb.BLACK, Rgb.WHITE);

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  /** Returns the ambient light that a ray sees: 0 where the pattern shows a, 1 where b. */
  private static double seen(
      Surface shape, Transform toWorld, Texture texture, Vector3d from, Vector3d to) {
    Vector3d d = to.minus(from).normalized();
    Vector3d up = Math.abs(d.y()) < 0.9 ? v(0, 1, 0) : v(1, 0, 0);
    Scene scene =
        new Scene.Builder("test")
            .camera(Camera.of(from, to, up, Projection.vertical(40)))
            .background(Background.constant(Rgb.grey(9)))
            .light(new Light.Ambient(Rgb.WHITE))
            .place(new Placement(shape, toWorld, Material.WHITE.textured(texture)))
            .build();
    Tracer tracer = new Tracer(Prepared.of(scene), 0, 0);
    Ray ray = new Ray();
    ray.set(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
    tracer.trace(ray, Double.POSITIVE_INFINITY);
    return tracer.r;
  }

  private static double seen(Surface shape, Texture texture, Vector3d from, Vector3d to) {
    return seen(shape, Transform.IDENTITY, texture, from, to);
  }

  private static int cell(double coordinate) {
    return (int) Math.floor(coordinate / 0.5);
  }

  /** Between two cells the rounding of a hit point decides. */
  private static boolean isWithinACell(double coordinate) {
    double places = coordinate / 0.5;
    return Math.abs(places - Math.rint(places)) > 1e-9;
  }

  private static double parity(int cells) {
    return Math.floorMod(cells, 2);
  }

  @Property(tries = 200)
  void aFloorShowsSquaresAndStripesAlongZ(
      @ForAll @DoubleRange(min = -3, max = 3) double x,
      @ForAll @DoubleRange(min = -3, max = 3) double z,
      @ForAll @IntRange(min = -2, max = 2) int height) {
    Plane floor = new Plane(v(7, 0.5 * height, 0), v(0, 1, 0));
    Vector3d from = v(x, 5, z);
    Vector3d to = v(x, -5, z);
    assertEquals(parity(cell(x) + cell(z)), seen(floor, CHECKER, from, to));
    assertEquals(parity(cell(z)), seen(floor, STRIPES, from, to));
  }

  @Property(tries = 200)
  void aWallShowsStripesAlongYAndASideWallAlongZ(
      @ForAll @DoubleRange(min = -3, max = 3) double u,
      @ForAll @DoubleRange(min = -3, max = 3) double v) {
    Assume.that(isWithinACell(u) && isWithinACell(v));
    Quad back = new Quad(v(-9, -9, 1), v(18, 0, 0), v(0, 18, 0));
    assertEquals(parity(cell(v)), seen(back, STRIPES, v(u, v, 5), v(u, v, 0)));
    assertEquals(parity(cell(u) + cell(v)), seen(back, CHECKER, v(u, v, 5), v(u, v, 0)));
    Quad side = new Quad(v(-1, -9, -9), v(0, 18, 0), v(0, 0, 18));
    assertEquals(parity(cell(v)), seen(side, STRIPES, v(5, u, v), v(-5, u, v)));
    assertEquals(parity(cell(u) + cell(v)), seen(side, CHECKER, v(5, u, v), v(-5, u, v)));
  }

  @Property(tries = 200)
  void everyFaceOfABoxLeavesOutItsAxisHoweverItIsTurned(
      @ForAll @DoubleRange(min = -0.99, max = 0.99) double u,
      @ForAll @DoubleRange(min = -0.99, max = 0.99) double v,
      @ForAll @IntRange(min = 0, max = 5) int face,
      @ForAll @DoubleRange(min = 0, max = 360) double degrees) {
    Box box = new Box(v(-1, -1, -1), v(1, 1, 1));
    Transform turned =
        Transform.rotate(Quaternion.aboutAxis(v(1, 2, 3), degrees))
            .then(Transform.translate(v(0.3, -0.2, 0.7)));
    Assume.that(isWithinACell(u) && isWithinACell(v));
    double side = face < 3 ? -1 : 1;
    Vector3d p =
        switch (face % 3) {
          case 0 -> v(side, u, v);
          case 1 -> v(u, side, v);
          default -> v(u, v, side);
        };
    Vector3d from = turned.point(p.times(3));
    assertEquals(parity(cell(u) + cell(v)), seen(box, turned, CHECKER, from, turned.point(p)));
    assertEquals(parity(cell(v)), seen(box, turned, STRIPES, from, turned.point(p)));
  }

  @Property(tries = 200)
  void aBallIsCutFromABlock(
      @ForAll @DoubleRange(min = -1, max = 1) double x,
      @ForAll @DoubleRange(min = -1, max = 1) double y,
      @ForAll @DoubleRange(min = 0.1, max = 1) double z) {
    Vector3d p = v(x, y, z).normalized().times(1.3);
    for (double along : new double[] {p.x(), p.y(), p.z()}) {
      Assume.that(isWithinACell(along));
    }
    Sphere ball = new Sphere(Vector3d.ZERO, 1.3);
    double expected = parity(cell(p.x()) + cell(p.y()) + cell(p.z()));
    assertEquals(expected, seen(ball, CHECKER, p.times(3), Vector3d.ZERO));
    assertEquals(parity(cell(p.z())), seen(ball, STRIPES, p.times(3), Vector3d.ZERO));
    // Flattened and moved, it carries its pattern along.
    Transform there = Transform.scale(v(2, 0.5, 1)).then(Transform.translate(v(3, 1, -2)));
    double seen = seen(ball, there, CHECKER, there.point(p.times(3)), there.point(p));
    assertEquals(expected, seen);
  }

  @Test
  void facesBetweenTwoCellsShowNoNoise() {
    // All of these lie where a solid pattern changes, at a coordinate of 0 or 1.
    Cylinder can = new Cylinder(v(0, 0, 0), v(0, 1, 0), 2, 2, true);
    Triangle floor = new Triangle(v(-9, 1, -9), v(9, 1, -9), v(0, 1, 9));
    Box box = new Box(v(-2, -1, -2), v(2, 1, 2));
    Pyramid tent =
        new Pyramid(v(0, -1, 0), List.of(v(-2, 1, -2), v(2, 1, -2), v(2, 1, 2), v(-2, 1, 2)));
    Transform turned = Transform.rotate(Quaternion.aboutAxis(v(1, 1, 0), 37));
    for (Surface shape : new Surface[] {can, floor, box, tent}) {
      for (int i = 0; i < 200; i++) {
        double x = -0.99 + 0.0097 * i;
        double z = 0.95 - 0.0083 * i;
        Vector3d from = v(x, 7, z);
        Vector3d to = v(x, 1, z);
        double expected = parity(cell(x) + cell(z));
        assertEquals(expected, seen(shape, CHECKER, from, to));
        assertEquals(expected, seen(shape, turned, CHECKER, turned.point(from), turned.point(to)));
      }
    }
  }

  @Test
  void aFaceAtTheSameAngleToTwoAxesIsOfOnePiece() {
    // Normal (0, 1, 1): y is left out, before and after a turn that rounds.
    Quad slope = new Quad(v(-4, -1, 1), v(8, 0, 0), v(0, 2, -2));
    for (int i = 0; i < 200; i++) {
      double x = -0.99 + 0.0097 * i;
      double z = 0.95 - 0.0083 * i;
      Transform turned = Transform.rotate(Quaternion.aboutAxis(v(3, 1, 2), i));
      Vector3d from = v(x, 5, z);
      Vector3d to = v(x, -z, z);
      double expected = parity(cell(x) + cell(z));
      assertEquals(expected, seen(slope, CHECKER, from, to));
      assertEquals(expected, seen(slope, turned, CHECKER, turned.point(from), turned.point(to)));
    }
  }

  @Test
  void aMeshIsSolid() {
    double[] points = {-9, 0.25, -9, 9, 0.25, -9, 0, 0.25, 9};
    Mesh high = new Mesh(points, new int[] {0, 1, 2});
    assertEquals(0, seen(high, CHECKER, v(0.1, 5, 0.1), v(0.1, 0, 0.1)));
    points[1] = points[4] = points[7] = 0.75;
    Mesh higher = new Mesh(points, new int[] {0, 1, 2});
    assertEquals(1, seen(higher, CHECKER, v(0.1, 5, 0.1), v(0.1, 0, 0.1)));
  }

  @Test
  void farAwayCellsAreStillEvenOrOdd() {
    assertEquals(Rgb.BLACK, CHECKER.at(1e99, -1e99, 3e50, Pattern.SOLID));
    assertEquals(Rgb.WHITE, CHECKER.at(1e99, -1e99, -0.25, Pattern.SOLID));
    assertEquals(Rgb.WHITE, STRIPES.at(0, 0, -0.25, Pattern.SOLID));
    assertEquals(Rgb.WHITE, STRIPES.at(0, 0, 0x1p51 + 0.5, Pattern.SOLID));
    assertEquals(Rgb.BLACK, STRIPES.at(0, 0, 0x1p51, Pattern.SOLID));
  }

  @Test
  void aTextureMultipliesAmbientAndDiffuseOnly() {
    Rgb colour = new Rgb(0.5, 0.25, 2);
    Material material =
        new Material(
                new Rgb(0.5, 1, 0.125),
                new Rgb(0.25, 0.5, 1),
                Rgb.grey(0.5),
                8,
                Rgb.BLACK,
                Rgb.grey(0.0625))
            .textured(new Stripes(1, colour, colour));
    Scene scene =
        new Scene.Builder("test")
            .camera(Camera.of(v(0, 4, 0), Vector3d.ZERO, v(0, 0, -1), Projection.vertical(40)))
            .light(new Light.Ambient(Rgb.grey(0.5)))
            .light(new Light.Directional(v(0, -1, 0), Rgb.grey(2)))
            .place(Placement.of(new Plane(Vector3d.ZERO, v(0, 1, 0)), material))
            .build();
    Prepared prepared = Prepared.of(scene);
    Tracer tracer = new Tracer(prepared, 0, 0);
    Ray ray = new Ray();
    ray.set(0, 4, 0, 0, -1, 0);
    tracer.trace(ray, Double.POSITIVE_INFINITY);
    double apart = 0.0625 + 2 * 0.5;
    assertEquals(apart + 0.5 * (0.5 * 0.5 + 2 * 0.25), tracer.r);
    assertEquals(apart + 0.25 * (0.5 * 1 + 2 * 0.5), tracer.g);
    assertEquals(apart + 2 * (0.5 * 0.125 + 2 * 1), tracer.b);
    // The bound on radiance counts the brightest colour of the pattern.
    assertEquals(tracer.b, prepared.radianceBound());
  }
}
