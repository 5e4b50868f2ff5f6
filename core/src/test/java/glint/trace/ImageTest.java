package glint.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Box;
import glint.geometry.CornerValues;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Pyramid;
import glint.geometry.Quad;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.image.ByteImage;
import glint.image.Noise;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.ImageTexture;
import glint.optics.Layout;
import glint.optics.Mapping;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Planar;
import glint.optics.Texel;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Camera;
import glint.scene.NamedMaterial;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.RenderPlan;
import glint.scene.Scene;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Which place of an image is seen where on a surface. */
class ImageTest {

  private static final ByteImage IMAGE = Noise.of(8, 8);
  private static final Transform THERE =
      Transform.scale(new Vector3d(2, -0.5, 1))
          .then(Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 2, 3), 70)))
          .then(Transform.translate(new Vector3d(3, 1, -2)));

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static ImageTexture texture(Mapping mapping) {
    return new ImageTexture(IMAGE, Layout.ONCE, Optional.ofNullable(mapping));
  }

  private static Material laid(Mapping mapping) {
    return Material.WHITE.textured(texture(mapping));
  }

  private static Rgb colour(double u, double v) {
    Texel texel = new Texel();
    texel.u = u;
    texel.v = v;
    texture(null).at(texel);
    return texel.color();
  }

  private static void assertSees(
      double u, double v, Scene.Builder scene, Vector3d from, Vector3d to) {
    Prepared prepared =
        Prepared.of(
            scene
                .camera(Camera.of(from, to, v(0.1, 0.2, 0.7), Projection.vertical(40)))
                .light(new Light.Ambient(Rgb.WHITE))
                .build());
    Vector3d d = to.minus(from).normalized();
    Ray ray = new Ray();
    for (Prepared each :
        List.of(prepared, Prepared.of(prepared.scene(), RenderPlan.everything()))) {
      Tracer tracer = new Tracer(each, 0, 0);
      ray.set(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
      tracer.trace(ray, Double.POSITIVE_INFINITY);
      Rgb expected = colour(u, v);
      assertEquals(expected.r(), tracer.r, 1e-9);
      assertEquals(expected.g(), tracer.g, 1e-9);
      assertEquals(expected.b(), tracer.b, 1e-9);
    }
  }

  /** Looks at a point of a surface from somewhere, where it is and carried away by a transform. */
  private static void assertShows(
      double u, double v, Surface shape, Mapping mapping, Vector3d from, Vector3d to) {
    for (Transform place : List.of(Transform.IDENTITY, THERE)) {
      Placement there = new Placement(shape, place, laid(mapping));
      Scene.Builder scene = new Scene.Builder("test").place(there);
      assertSees(u, v, scene, place.point(from), place.point(to));
    }
  }

  @Property(tries = 50)
  void everyKindOfSurfaceHasItsOwnWay(
      @ForAll @DoubleRange(min = 0.01, max = 0.99) double u,
      @ForAll @DoubleRange(min = 0.01, max = 0.49) double v) {
    Quad quad = new Quad(v(1, 2, 3), v(2, 0, 0), v(1, 3, 0));
    Vector3d p = v(1 + 2 * u + v, 2 + 3 * v, 3);
    assertShows(u, v, quad, null, p.plus(v(1, 1, 5)), p);
    Triangle triangle = new Triangle(v(1, 2, 3), v(3, 2, 3), v(2, 5, 3));
    Vector3d q = v(1 + u + v, 2 + 3 * v, 3); // at u / 2
    assertShows(u / 2, v, triangle, null, q.plus(v(1, 1, 5)), q);
    Box box = new Box(v(-1, -1, -1), v(1, 1, 1));
    assertShows(u, v, box, null, v(2 * u - 1, 2 * v - 1, 5), v(2 * u - 1, 2 * v - 1, 1));
    assertShows(u, v, box, null, v(5, 2 * v - 1, 1 - 2 * u), v(1, 2 * v - 1, 1 - 2 * u));
    double longitude = 2 * Math.PI * (u - 0.5);
    Vector3d around = v(Math.sin(longitude), 0, Math.cos(longitude));
    Cylinder can = new Cylinder(v(0, 0, 0), v(0, 2, 0), 1, 1, true);
    Vector3d side = around.plus(v(0, 2 * v, 0));
    assertShows(u, v, can, null, side.plus(around), side);
    double latitude = Math.PI * (v - 0.5);
    Vector3d globe = around.times(Math.cos(latitude)).plus(v(0, Math.sin(latitude), 0));
    Sphere ball = new Sphere(v(1, 1, 1), 2);
    assertShows(u, v, ball, null, globe.times(5).plus(v(1, 1, 1)), v(1, 1, 1));
    Plane wall = new Plane(v(0, 0, 7), v(0, 0, 1));
    assertShows(u, v, wall, null, v(u - 3, v + 5, 9), v(u - 3, v + 5, 7));
    Pyramid tent =
        new Pyramid(v(0, 3, 0), List.of(v(-2, 0, -2), v(2, 0, -2), v(2, 0, 2), v(-2, 0, 2)));
    assertShows(u, v, tent, null, v(u, -5, -v), v(u, 0, -v));
    Mapping planar = Planar.of(v(0, 0, 0), v(0.5, 0, 0), v(0, 1, 0));
    assertShows(u, v, tent, planar, v(0.5 * u, v, 5), v(0.5 * u, v, 0));
  }

  /** Two triangles, the first with three points of the image, the second with one of them. */
  private static Mesh mesh() {
    double[] points = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 1, 4, 0, 1, 0, 4, 1};
    double[] pairs = {0.25, 0.5, 3.5, 0.5, 0.25, -1.5};
    return new Mesh(points, new int[] {0, 1, 2, 3, 4, 5})
        .withTexture(new CornerValues(2, pairs, new int[] {0, 1, 2, -1, 1, -1}));
  }

  private static final double[][] WEIGHTS = {{0.2, 0.3}, {0.6, 0.1}, {0.01, 0.98}};

  @Test
  void aMeshShowsTheImageBetweenItsTexturePoints() {
    for (double[] w : WEIGHTS) {
      Vector3d p = v(4 * w[0], 4 * w[1], 0);
      double u = 0.25 + w[0] * 3.25;
      double v = 0.5 - w[1] * 2;
      assertShows(u, v, mesh(), null, p.plus(v(0, 0, -3)), p);
      Vector3d q = v(4 * w[0], 4 * w[1], 1);
      assertShows(3.5 * w[0], 0.5 * w[0], mesh(), null, q.plus(v(0, 0, 3)), q);
      // A mapping that is written hides the points.
      Mapping planar = Planar.of(v(0, 0, 0), v(1, 0, 0), v(0, 1, 0));
      assertShows(q.x(), q.y(), mesh(), planar, q.plus(v(0, 0, 3)), q);
    }
    assertTrue(mesh().hasTexturePoints());
  }

  @Test
  void aModelAtManyPlacesShowsItAtAllOfThem() {
    Transform shift = Transform.translate(v(0, 0, 20)).then(THERE);
    Mesh mesh = mesh().inParts(new int[] {0, 1}, new int[] {0, 1});
    List<NamedMaterial> both =
        List.of(new NamedMaterial("", Material.WHITE), new NamedMaterial("", laid(null)));
    for (double[] w : WEIGHTS) {
      Vector3d q = v(4 * w[0], 4 * w[1], 1);
      for (Transform looked : List.of(THERE, shift)) {
        Scene.Builder scene = new Scene.Builder("test");
        scene.place(Placement.of(new Sphere(v(0, 0, -9), 1), Material.WHITE));
        for (Transform place : List.of(THERE, shift, Transform.IDENTITY)) {
          scene.place(new Placement(mesh, place, both, 0));
        }
        Vector3d from = looked.point(q.plus(v(0, 0, 2)));
        assertSees(3.5 * w[0], 0.5 * w[0], scene, from, looked.point(q));
      }
    }
  }

  /** Of two filters that coincide the one of the higher priority is seen, with its own triangle. */
  @Test
  void coincidentFacesShowTheImageOfTheOneThatIsSeen() {
    Material glass =
        new Material(
                Rgb.WHITE,
                Rgb.WHITE,
                Rgb.BLACK,
                1,
                Rgb.BLACK,
                Rgb.BLACK,
                Rgb.grey(1e-300),
                new Medium(1.5, Rgb.BLACK, 1))
            .textured(texture(null));
    Material under =
        new Material(
            Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK, Rgb.WHITE, Medium.VACUUM);
    double[] w = WEIGHTS[0];
    Vector3d p = v(4 * w[0], 4 * w[1], 0);
    Scene.Builder scene = new Scene.Builder("test");
    double near = -1e-15; // met first, but within the rounding of the other
    Triangle filter = new Triangle(v(4, 0, near), v(0, 4, near), v(0, 0, near));
    scene.place(Placement.of(filter, under));
    scene.place(Placement.of(mesh(), glass));
    assertSees(0.25 + w[0] * 3.25, 0.5 - w[1] * 2, scene, p.plus(v(0, 0, -3)), p);
  }

  /** With two rays to a pixel of the image each way, every one shows the mean over its square. */
  @Test
  void aPictureOfAnImageIsAsBrightAsTheImage() {
    Scene scene =
        new Scene.Builder("test")
            .size(16, 16)
            .camera(Camera.of(v(0, 0, 5), Vector3d.ZERO, v(0, 1, 0), new Orthographic(2)))
            .light(new Light.Ambient(Rgb.WHITE))
            .place(Placement.of(new Quad(v(-1, -1, 0), v(2, 0, 0), v(0, 2, 0)), laid(null)))
            .build();
    RenderSettings settings =
        new RenderSettings(16, 16, 1, 0, OptionalInt.empty(), 1, 32, Set.of());
    double[] rgb = new Renderer(Prepared.of(scene), settings).render(Progress.NONE).image().rgb();
    for (int channel = 0; channel < 3; channel++) {
      double expected = 0;
      for (int i = 0; i < 64; i++) {
        expected += Transfer.SRGB.decode(IMAGE.code(i % 8, i / 8, channel) / 255.0) / 64;
      }
      double sum = 0;
      for (int i = channel; i < rgb.length; i += 3) {
        sum += rgb[i] / 256;
      }
      assertEquals(expected, sum, 1e-13);
    }
    // Upper left pixel of the picture: a quarter into that of the image, whose neighbours repeat.
    Rgb first = colour(1 / 32.0, 31 / 32.0);
    assertEquals(first.r(), rgb[0], 1e-13);
  }
}
