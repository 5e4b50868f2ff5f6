package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.CornerValues;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.image.Image;
import glint.light.Light;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.NamedMaterial;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.RenderPlan;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Meshes whose parts are of different materials. */
class PartsTest {

  private static final Material MATT =
      new Material(Rgb.grey(0.2), new Rgb(0.7, 0.3, 0.2), Rgb.grey(0.4), 30, Rgb.BLACK, Rgb.BLACK);
  private static final Material MIRROR =
      new Material(Rgb.BLACK, Rgb.grey(0.1), Rgb.BLACK, 1, new Rgb(0.7, 0.8, 0.9), Rgb.BLACK);
  private static final Material GLASS =
      new Material(
          Rgb.BLACK,
          Rgb.BLACK,
          Rgb.grey(0.3),
          60,
          Rgb.BLACK,
          Rgb.BLACK,
          Rgb.WHITE,
          new Medium(1.5, new Rgb(0.4, 0.1, 0.2), 0));
  private static final List<Material> MATERIALS = List.of(MATT, MIRROR, GLASS);

  /** Three octahedra; of the parts, all faces of the third are one. */
  private static final int[] STARTS = {0, 3, 5, 9, 11, 16};

  private static final int[] PARTS = {0, 1, 0, 1, 0, 2};

  private static final double[] OCTAHEDRON = {
    1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1
  };
  private static final int[] FACES = {
    0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5
  };

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Mesh octahedra() {
    double[] points = new double[54];
    int[] corners = new int[72];
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 18; j++) {
        points[18 * i + j] = OCTAHEDRON[j] + (j % 3 == 0 ? 2.2 * (i - 1) : 0);
      }
      for (int j = 0; j < 24; j++) {
        corners[24 * i + j] = FACES[j] + 6 * i;
      }
    }
    return new Mesh(points, corners);
  }

  private static Mesh inParts() {
    return octahedra().inParts(STARTS, PARTS);
  }

  /** The triangles of one part as a mesh of its own. */
  private static Mesh part(int part) {
    Mesh all = inParts();
    List<Integer> corners = new ArrayList<>();
    for (int i = 0; i < all.triangles(); i++) {
      if (all.part(i) == part) {
        for (int j = 0; j < 3; j++) {
          corners.add(6 * (i / 8) + FACES[3 * (i % 8) + j]);
        }
      }
    }
    double[] points = new double[54];
    for (int j = 0; j < 54; j++) {
      points[j] = OCTAHEDRON[j % 18] + (j % 3 == 0 ? 2.2 * (j / 18 - 1) : 0);
    }
    return new Mesh(points, corners.stream().mapToInt(i -> i).toArray());
  }

  private static List<NamedMaterial> named(List<Material> materials) {
    List<NamedMaterial> named = new ArrayList<>();
    for (Material material : materials) {
      named.add(new NamedMaterial("m" + named.size(), material));
    }
    return named;
  }

  private static Prepared scene(boolean everything, Placement... placements) {
    Scene.Builder scene =
        new Scene.Builder("parts")
            .camera(Camera.of(v(1.5, 2, 7), v(0, 0.2, 0), v(0, 1, 0), Projection.vertical(40)))
            .background(new Background(Rgb.grey(0.2), new Rgb(0.4, 0.6, 0.9)))
            .light(new Light.Ambient(Rgb.grey(0.3)))
            .light(new Light.Point(v(3, 5, 4), Rgb.grey(0.8), false))
            .place(Placement.of(new Plane(v(0, -1, 0), v(0, 1, 0)), Material.WHITE));
    for (Placement placement : placements) {
      scene.place(placement);
    }
    return everything
        ? Prepared.of(scene.build(), RenderPlan.everything())
        : Prepared.of(scene.build());
  }

  private static RenderResult render(Prepared scene) {
    RenderSettings settings =
        new RenderSettings(96, 64, 1, 0, OptionalInt.empty(), 2, 32, Set.of(Aov.values()));
    return new Renderer(scene, settings).render(Progress.NONE);
  }

  private static String hash(Prepared scene) {
    return render(scene).image().sha256();
  }

  @Test
  void partsAreWhatMeshesOfTheirOwnAre() {
    for (Transform place :
        List.of(
            Transform.IDENTITY,
            Transform.scale(v(-1, 1, 0.9)).then(Transform.translate(v(0.1, 0, 0))))) {
      Placement whole = new Placement(inParts(), place, named(MATERIALS), 0);
      Placement[] apart = new Placement[3];
      for (int i = 0; i < 3; i++) {
        apart[i] = new Placement(part(i), place, MATERIALS.get(i));
      }
      String expected = hash(scene(false, apart));
      assertEquals(expected, hash(scene(false, whole)));
      assertEquals(expected, hash(scene(true, whole)));
      // Each part has its own material: others give another image.
      Placement other = new Placement(inParts(), place, named(List.of(MIRROR, MATT, GLASS)), 0);
      assertNotEquals(expected, hash(scene(false, other)));
    }
  }

  @Test
  void oneMaterialIsForAllParts() {
    Placement parts = new Placement(inParts(), Transform.IDENTITY, MIRROR);
    Placement plain = new Placement(octahedra(), Transform.IDENTITY, MIRROR);
    assertEquals(hash(scene(false, plain)), hash(scene(false, parts)));
    List<NamedMaterial> same = named(List.of(MIRROR, MIRROR, MIRROR));
    Placement thrice = new Placement(inParts(), Transform.IDENTITY, same, 0);
    assertEquals(hash(scene(false, plain)), hash(scene(false, thrice)));
  }

  @Test
  void smoothNormalsFollowTheTriangleWhateverItsPart() {
    CornerValues none = CornerValues.NONE;
    int[] groups = new int[24];
    Arrays.fill(groups, 1);
    List<NamedMaterial> same = named(List.of(MATT, MATT, MATT));
    Mesh smooth = octahedra().withNormals(none, groups);
    String expected = hash(scene(false, new Placement(smooth, Transform.IDENTITY, MATT)));
    Mesh first = smooth.inParts(STARTS, PARTS);
    Mesh last = inParts().withNormals(none, groups);
    assertEquals(expected, hash(scene(false, new Placement(first, Transform.IDENTITY, same, 0))));
    assertEquals(expected, hash(scene(false, new Placement(last, Transform.IDENTITY, same, 0))));
    assertEquals(3, last.parts());
    assertEquals(3, last.smoothed(60).parts());
  }

  @Test
  void thePlacementKeepsItsNumberAndEveryPartItsColour() {
    Placement whole = new Placement(inParts(), Transform.IDENTITY, named(MATERIALS), 7);
    Placement after = Placement.of(new Plane(v(0, 0, -9), v(0, 0, 1)), Material.WHITE);
    Prepared prepared = scene(false, whole, after);
    RenderResult result = render(prepared);
    Image ids = result.aovs().get(Aov.ID);
    Image albedo = result.aovs().get(Aov.ALBEDO);
    Set<Double> seen = new TreeSet<>();
    Set<Double> reds = new TreeSet<>();
    for (int i = 0; i < ids.rgb().length; i += 3) {
      seen.add(ids.rgb()[i]);
      if (ids.rgb()[i] == 1) {
        reds.add(albedo.rgb()[i]);
      }
    }
    assertEquals(Set.of(0.0, 1.0, 2.0), seen);
    assertEquals(Set.of(0.7, 0.1, 0.0), reds);
    assertEquals(5, prepared.surfaces());
    assertEquals(1, prepared.place(3));
    assertEquals("m2", prepared.materialName(3));
    assertEquals("", prepared.materialName(4));
    assertEquals(2, prepared.place(4));
  }

  @Test
  void thePlanLooksAtEveryPart() {
    Placement whole = new Placement(inParts(), Transform.IDENTITY, named(MATERIALS), 0);
    RenderPlan plan = scene(false, whole).plan();
    assertTrue(plan.mirrors().used() && plan.refraction().used() && plan.highlights().used());
    assertTrue(plan.mirrors().reason().endsWith(": 1"), "one surface, not one for each part");
  }

  @Test
  void partsThatDoNotFitAreRefused() {
    assertThrows(
        IllegalArgumentException.class,
        () -> new Placement(inParts(), Transform.IDENTITY, named(List.of(MATT, MIRROR)), 0));
    assertThrows(
        IllegalArgumentException.class,
        () -> new Placement(inParts(), Transform.IDENTITY, List.of(), 0));
    assertThrows(
        IllegalArgumentException.class,
        () -> new Placement(octahedra(), Transform.IDENTITY, named(List.of(MATT, MIRROR)), 0));
    for (int[][] bad :
        new int[][][] {{{}, {}}, {{1}, {0}}, {{0, 2}, {0}}, {{0, 2, 2}, {0, 1, 0}}, {{0}, {-1}}}) {
      assertThrows(IllegalArgumentException.class, () -> octahedra().inParts(bad[0], bad[1]));
    }
    Mesh mesh = octahedra().inParts(new int[] {0, 8}, new int[] {2, 0});
    assertEquals(3, mesh.parts());
    assertEquals(2, mesh.part(7));
    assertEquals(0, mesh.part(8));
    assertEquals(0, mesh.part(23));
    assertEquals(1, octahedra().parts());
    assertEquals(0, octahedra().part(9));
  }
}
