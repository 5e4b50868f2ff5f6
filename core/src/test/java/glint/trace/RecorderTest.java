package glint.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.CornerValues;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Stripes;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.NamedMaterial;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import glint.trace.RayTree.Fate;
import glint.trace.RayTree.Kind;
import glint.trace.RayTree.Lighting;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** What a recorder writes down of a ray is what the tracer did. */
class RecorderTest {

  private static final Material GLASS = clear(1, new Medium(1.5, Rgb.grey(0.1), 0));

  private static final Material MATT =
      new Material(Rgb.BLACK, Rgb.grey(0.5), Rgb.BLACK, 1, Rgb.grey(0.25), Rgb.BLACK);

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Material clear(double transparency, Medium interior) {
    return new Material(
        Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK, Rgb.grey(transparency), interior);
  }

  /** A floor seen from above, in light that comes straight down. */
  private static Scene.Builder floor() {
    return new Scene.Builder("floor")
        .camera(Camera.of(v(0, 9, 0), v(0, 0, 0.1), v(0, 0, 1), Projection.vertical(40)))
        .background(Background.constant(Rgb.grey(0.125)))
        .place(
            new Placement(
                new Plane(Vector3d.ZERO, v(0, 1, 0)),
                Transform.IDENTITY,
                List.of(new NamedMaterial("matt", MATT)),
                12));
  }

  private static RayTree trace(Scene scene, int depth, Vector3d from, Vector3d towards) {
    Recorder recorder = new Recorder();
    Prepared prepared = Prepared.of(scene);
    Tracer told = new Tracer(prepared, depth, 1e-3, recorder);
    Tracer silent = new Tracer(prepared, depth, 1e-3);
    Vector3d d = towards.normalized();
    Ray ray = new Ray();
    ray.set(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
    told.trace(ray, Double.POSITIVE_INFINITY);
    told.trace(ray, Double.POSITIVE_INFINITY); // the second is told of alone
    silent.trace(ray, Double.POSITIVE_INFINITY);
    RayTree tree = recorder.tree();
    assertEquals(new Rgb(silent.r, silent.g, silent.b), new Rgb(told.r, told.g, told.b));
    assertEquals(new Rgb(silent.r, silent.g, silent.b), tree.radiance());
    double cut = 0;
    for (RayTree each : tree.rays()) {
      for (RayTree.Cut one : each.cuts()) {
        cut += one.missing();
      }
    }
    assertEquals(silent.cut, cut);
    return tree;
  }

  /** A floor under every kind of light: one is seen, the others not, each for its own reason. */
  private static Scene lights() {
    return floor()
        .place(Placement.of(new Sphere(v(0, 4, 0), 1), clear(0.5, Medium.VACUUM)))
        .place(Placement.of(new Sphere(v(3, 3, 0), 1), Material.WHITE))
        .light(new Light.Ambient(Rgb.grey(0.125)))
        .light(new Light.Directional(v(0, -1, 0), Rgb.WHITE))
        .light(new Light.Point(v(6, 6, 0), Rgb.WHITE, false))
        .light(new Light.Point(v(0, -1, 0), Rgb.WHITE, false))
        .light(new Light.Spot(v(0, 5, 5), v(0, 9, 5), Rgb.WHITE, 60, 0))
        .build();
  }

  @Test
  void aLightIsToldWithWhatShadowsOrDimsIt() {
    RayTree tree = trace(lights(), 9, v(0, 1, 0), v(0, -1, 0));
    List<Lighting> lights = tree.sight().lights();
    List<Fate> fates = lights.stream().map(Lighting::fate).collect(Collectors.toList());
    assertEquals(List.of(Fate.LIT, Fate.SHADOWED, Fate.BEHIND, Fate.DARK), fates);
    Lighting seen = lights.get(0);
    assertEquals(1, seen.light());
    assertEquals(1, seen.towards().y());
    assertEquals(1, seen.cos());
    assertEquals(Rgb.grey(0.25), seen.passing());
    assertEquals(Rgb.grey(0.125), seen.added());
    assertEquals(2, seen.crossings().size());
    assertEquals(v(0, 3, 0), seen.crossings().get(0).point());
    assertEquals(Rgb.grey(0.5), seen.crossings().get(0).passing());
    assertEquals(v(0, 5, 0), seen.crossings().get(1).point());
    Lighting shadowed = lights.get(1);
    assertEquals(1, shadowed.crossings().size());
    assertEquals(2, shadowed.crossings().get(0).surface());
    assertEquals(Rgb.BLACK, shadowed.crossings().get(0).passing());
    assertEquals(Rgb.BLACK, shadowed.passing());
    assertEquals(-1, lights.get(2).cos());
    assertEquals(Rgb.BLACK, tree.sight().own());
    assertEquals(Rgb.grey(0.125), tree.sight().radiance());
  }

  @Test
  void whereNothingIsTransparentTheBlockerIsToldAllTheSame() {
    Scene scene =
        floor()
            .place(Placement.of(new Sphere(v(0, 4, 0), 1), Material.WHITE))
            .light(new Light.Directional(v(0, -1, 0), Rgb.WHITE))
            .build();
    Lighting light = trace(scene, 9, v(0, 1, 0), v(0, -1, 0)).sight().lights().get(0);
    assertEquals(Fate.SHADOWED, light.fate());
    assertEquals(1, light.crossings().get(0).surface());
    assertEquals(v(0, 3, 0), light.crossings().get(0).point());
  }

  @Test
  void theWayThroughGlassIsToldBounceByBounce() {
    Scene scene = floor().place(Placement.of(new Sphere(v(0, 4, 0), 1), GLASS)).build();
    RayTree camera = trace(scene, 3, v(0, 9, 0), v(0, -1, 0));
    assertEquals(Kind.CAMERA, camera.kind());
    assertEquals(0, camera.parent());
    RayTree.Meeting top = camera.met().orElseThrow();
    assertEquals(1, top.surface());
    assertEquals(4, top.t());
    assertEquals(v(0, 5, 0), top.point());
    assertEquals(v(0, 1, 0), top.normal());
    assertEquals(1, top.cos());
    assertEquals(Medium.VACUUM, top.before());
    RayTree.Boundary way = top.boundary().orElseThrow();
    assertEquals(GLASS.interior(), way.beyond());
    assertEquals(1 / 1.5, way.eta());
    assertEquals(0.04, way.reflected(), 1e-15);

    RayTree inside = camera.children().get(0);
    assertEquals(Kind.REFRACTION, inside.kind());
    assertEquals(1, inside.bounces());
    assertEquals(0.96, inside.weight().r(), 1e-15);
    double bottom = 0.96 * StrictMath.exp(-0.2);
    assertEquals(bottom, inside.sight().weight().r(), 1e-15, "what two units of glass leave");
    RayTree mirrored = camera.children().get(1);
    assertEquals(Kind.REFLECTION, mirrored.kind());
    assertFalse(mirrored.met().isPresent());
    assertEquals(Rgb.grey(0.125), mirrored.sight().own());
    assertTrue(mirrored.number() > inside.children().get(0).number(), "depth first");

    RayTree below = inside.children().get(0);
    assertEquals(inside.number(), below.parent());
    assertEquals(0, below.met().orElseThrow().surface());
    RayTree back = below.children().get(0);
    assertEquals(Kind.REFLECTION, back.kind());
    assertEquals(3, back.bounces());
    assertEquals(
        List.of(RayTree.Reason.DEPTH, RayTree.Reason.DEPTH),
        back.cuts().stream().map(RayTree.Cut::reason).collect(Collectors.toList()));
    assertEquals(
        List.of(Kind.REFRACTION, Kind.REFLECTION),
        back.cuts().stream().map(RayTree.Cut::kind).collect(Collectors.toList()));
    RayTree deep = trace(scene, 99, v(0, 9, 0), v(0, -1, 0));
    assertTrue(
        deep.rays().stream()
            .flatMap(ray -> ray.cuts().stream())
            .allMatch(cut -> cut.reason() == RayTree.Reason.CONTRIBUTION));
  }

  @Test
  void straightOnIsNoBounceAndHiddenBoundariesArePassed() {
    Scene scene =
        floor()
            .place(Placement.of(new Sphere(v(0, 6, 0), 1), clear(0.5, Medium.VACUUM)))
            .place(Placement.of(new Box(v(-1, 1, -1), v(1, 3, 1)), GLASS))
            .place(Placement.of(new Box(v(-1, 2, -1), v(1, 4, 1)), GLASS))
            .build();
    RayTree camera = trace(scene, 9, v(0, 9, 0), v(0, -1, 0));
    RayTree through = camera.children().get(0);
    assertEquals(Kind.STRAIGHT, through.kind());
    assertEquals(0, through.bounces());
    assertEquals(camera.origin(), through.origin());
    RayTree glass = through.children().get(0).children().get(0);
    assertEquals(Kind.REFRACTION, glass.kind());
    List<Integer> hidden =
        glass.passed().stream().map(RayTree.Meeting::surface).collect(Collectors.toList());
    assertEquals(List.of(2, 3), hidden, "in glass the lower box begins, then the upper one ends");
    assertEquals(v(0, 1, 0), glass.met().orElseThrow().point());
  }

  @Test
  void theTextSaysItAll() {
    RayTree tree = trace(lights(), 0, v(0, 1, 0), v(0, -1, 0));
    assertEquals(
        """
        ray 1: camera, from (0, 1, 0), along (0, -1, 0), weight 1
          meets surface 0 (plane of matt, line 12), at t 1, point (0, 0, 0), normal (0, 1, 0), cos 1
          light 1 (directional) is seen, cos 1, adds 0.125
            through surface 1 (sphere) at (0, 3, 0), Fresnel reflects 0, 0.5 is left
            through surface 1 (sphere) at (0, 5, 0), Fresnel reflects 0, 0.25 is left
            in all 0.25 of it passes
          light 2 (point) is shadowed, cos 0.707107
            by surface 2 (sphere) at (2.29289, 2.29289, 0)
          light 3 (point) is behind the surface, cos -1
          light 4 (spot) sends nothing here
          own light 0
          gives 0.125 at weight 1, which adds (0.125, 0.125, 0.125)
          no reflection: too deep, weight 0.25, at most 1.03125 is missing
        the ray gives (0.125, 0.125, 0.125)
        """,
        String.join("\n", RayTreeText.of(Prepared.of(lights()), tree)) + "\n");
  }

  @Test
  void shadingNormalsAndTexturesAreTold() {
    double[] points = {-1, 1, -1, 1, 1, -1, 0, 1, 2};
    CornerValues slanted = new CornerValues(3, new double[] {0.6, 0.8, 0}, new int[] {0, 0, 0});
    Mesh curved = new Mesh(points, new int[] {0, 2, 1}).withNormals(slanted, new int[1]);
    Material striped = MATT.textured(new Stripes(9, new Rgb(0.5, 0.25, 1), Rgb.BLACK));
    Scene.Builder builder = floor().place(Placement.of(curved, striped));
    Scene scene = builder.light(new Light.Directional(v(0, -1, 0), Rgb.WHITE)).build();
    RayTree tree = trace(scene, 0, v(0.1, 2, 0.1), v(0, -1, 0));
    RayTree.Meeting met = tree.met().orElseThrow();
    assertEquals(v(0, 1, 0), met.normal());
    assertEquals(0.6, met.shading().x(), 1e-15);
    assertEquals(0.8, met.cos(), 1e-15);
    assertEquals(new Rgb(0.5, 0.25, 1), tree.sight().pattern());
    List<String> lines = RayTreeText.of(Prepared.of(scene), tree);
    assertEquals(
        "  meets surface 1 (mesh), at t 1, point (0.1, 1, 0.1), normal (0, 1, 0),"
            + " shading normal (0.6, 0.8, 0), cos 0.8",
        lines.get(1));
    assertEquals("  texture (0.5, 0.25, 1)", lines.get(2));
    assertEquals("  light 0 (directional) is seen, cos 0.8, adds (0.2, 0.1, 0.4)", lines.get(3));
  }
}
