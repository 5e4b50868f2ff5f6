package glint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.accel.Intersector;
import glint.color.Rgb;
import glint.geometry.CornerValues;
import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Ray;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Checker;
import glint.optics.Material;
import glint.optics.Medium;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Meshes that stand at several places are kept once, and are seen as if each had its own. */
class InstancesTest {

  private static final Material GLASS =
      new Material(
          Rgb.BLACK,
          Rgb.grey(0.1),
          Rgb.grey(0.3),
          60,
          Rgb.BLACK,
          Rgb.BLACK,
          Rgb.grey(0.9),
          new Medium(1.4, new Rgb(0.1, 0.5, 0.3), 0));

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  /** A tetrahedron around the origin whose corners, if it is round, have normals. */
  private static Mesh tetrahedron(boolean round) {
    double[] points = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
    int[] corners = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    Mesh mesh = new Mesh(points, corners);
    return round
        ? mesh.withNormals(new CornerValues(3, points.clone(), corners), new int[0])
        : mesh;
  }

  private static Transform place(Random r, int i) {
    int row = i / 3;
    Vector3d factors = v(i % 2 == 0 ? 0.5 : -0.5, 0.3 + 0.4 * r.nextDouble(), 0.6);
    Vector3d axis = v(r.nextDouble(), r.nextDouble(), 0.1 + r.nextDouble());
    return Transform.scale(factors)
        .then(Transform.rotate(Quaternion.aboutAxis(axis, 360 * r.nextDouble())))
        .then(Transform.translate(v(2.4 * (i % 3) - 2.4, 2.4 * row - 2.4, r.nextDouble())));
  }

  private static Scene.Builder scene(int size) {
    return new Scene.Builder("instances")
        .size(size, size)
        .camera(
            Camera.of(v(0.3, 0.2, 12), Vector3d.ZERO, v(0, 1, 0), new Perspective(40, false, 0)))
        .background(new Background(Rgb.grey(0.2), new Rgb(0.3, 0.4, 0.9)))
        .light(new Light.Directional(v(-1, -2, -3), Rgb.grey(0.8)));
  }

  private static Scene nine(Mesh mesh, Material material, int size) {
    Random r = new Random(5);
    Scene.Builder scene = scene(size);
    for (int i = 0; i < 9; i++) {
      scene.place(new Placement(mesh, place(r, i), material));
    }
    return scene.build();
  }

  /** The same scene, each placement with a mesh of its own. */
  private static Prepared flattened(Scene scene) {
    RenderPlan plan = Prepared.of(scene).plan();
    assertTrue(plan.instances().used());
    RenderPlan without =
        new RenderPlan(
            plan.lens(),
            plan.motion(),
            new Decision("instances", false, "switched off"),
            plan.tree(),
            plan.pencils(),
            plan.smoothNormals(),
            plan.directLight(),
            plan.lamps(),
            plan.shadows(),
            plan.textures(),
            plan.images(),
            plan.highlights(),
            plan.mirrors(),
            plan.gloss(),
            plan.refraction(),
            plan.sky());
    return Prepared.of(scene, without);
  }

  private static double[] pixels(Prepared scene) {
    Scene s = scene.scene();
    RenderSettings settings =
        new RenderSettings(s.width(), s.height(), 1, 0, OptionalInt.of(6), 2, 32, Set.of());
    return new Renderer(scene, settings).render(Progress.NONE).image().rgb();
  }

  @Test
  void instancesLookLikeMeshesOfTheirOwn() {
    for (boolean round : new boolean[] {false, true}) {
      for (Material material : new Material[] {Material.WHITE, GLASS}) {
        Scene scene = nine(tetrahedron(round), material, 100);
        double[] one = pixels(Prepared.of(scene));
        double[] other = pixels(flattened(scene));
        int different = 0;
        int lit = 0;
        for (int i = 0; i < one.length; i++) {
          different += Math.abs(one[i] - other[i]) > 1e-9 ? 1 : 0;
          lit += one[i] > 0 ? 1 : 0;
        }
        // Rounding may decide the other way where a ray meets an edge.
        assertTrue(different <= 6, different + " values differ");
        assertTrue(lit > one.length / 2);
      }
    }
  }

  @Test
  void hitsTellPlaceAndTriangleAndSide() {
    Mesh mesh = tetrahedron(false);
    Scene scene = nine(mesh, Material.WHITE, 10);
    Intersector instances = Prepared.of(scene).intersector();
    Prepared own = flattened(scene);
    Intersector meshes = own.intersector();
    Prepared shared = Prepared.of(scene);
    Random r = new Random(6);
    Ray ray = new Ray();
    Hit a = new Hit();
    Hit b = new Hit();
    int hits = 0;
    for (int i = 0; i < 20_000; i++) {
      ray.set(
          3 * r.nextGaussian(), 3 * r.nextGaussian(), 9, r.nextGaussian(), r.nextGaussian(), -9);
      instances.closest(ray, Double.POSITIVE_INFINITY, a);
      meshes.closest(ray, Double.POSITIVE_INFINITY, b);
      assertEquals(b.found(), a.found());
      if (a.found()) {
        hits++;
        a.curved = true; // as where a sphere was hit before
        instances.resolve(ray, a);
        meshes.resolve(ray, b);
        assertFalse(a.curved);
        assertEquals(b.t, a.t, 1e-12);
        assertEquals(b.surface, a.surface);
        assertEquals(b.crossing, a.crossing);
        assertEquals(own.primitives().triangle(b), shared.primitives().triangle(a));
        assertEquals(0, v(b.nx - a.nx, b.ny - a.ny, b.nz - a.nz).length(), 1e-12);
        assertEquals(0, v(b.px - a.px, b.py - a.py, b.pz - a.pz).length(), 1e-12);
      }
    }
    assertTrue(hits > 2000, "hits: " + hits);
  }

  /** All four triangles that meet at a corner lie at one parameter; each is met once, in order. */
  @Test
  void aRayThatLeavesOneTriangleOfAnInstanceMeetsAnother() {
    double[] points = {-1, -1, 0, 1, -1, 0, 0, 1, 0, 1, -1, 2};
    Mesh floorAndWall = new Mesh(points, new int[] {0, 1, 2, 1, 3, 2});
    Scene.Builder scene = scene(8).place(Placement.of(floorAndWall, Material.WHITE));
    Transform aside = Transform.translate(v(0, 9, 0));
    Scene two = scene.place(new Placement(floorAndWall, aside, Material.WHITE)).build();
    Intersector search = Prepared.of(two).intersector();
    Ray ray = new Ray();
    ray.set(0, -0.5, 3, 0, 0, -1);
    Hit hit = new Hit();
    search.closest(ray, 9, hit);
    search.resolve(ray, hit);
    hit.face(ray);
    hit.spawn(1, 0, 0, 1, ray);
    assertTrue(search.any(ray, 9, new Hit()));
    hit.spawnToLight(1, 0, 0, ray);
    assertTrue(search.any(ray, 9, new Hit()));
  }

  @Test
  void goingOnBehindAHitMeetsEveryTriangleOnce() {
    double[] points = {0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0};
    Mesh pyramid = new Mesh(points, new int[] {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1});
    Scene scene =
        scene(10)
            .place(Placement.of(pyramid, Material.WHITE))
            .place(new Placement(pyramid, Transform.scale(v(2, 2, 1)), Material.WHITE))
            .build();
    Prepared prepared = Prepared.of(scene);
    Ray ray = new Ray();
    Hit hit = new Hit();
    for (Intersector search : List.of(prepared.intersector(), PreparedFacts.scan(prepared))) {
      ray.set(0, 0, 9, 0, 0, -1);
      List<String> met = new ArrayList<>();
      search.closest(ray, Double.POSITIVE_INFINITY, hit);
      while (hit.found()) {
        search.resolve(ray, hit);
        assertEquals(8, hit.t);
        met.add(hit.surface + "/" + prepared.primitives().triangle(hit));
        ray.goOnAfter(hit);
        search.closest(ray, Double.POSITIVE_INFINITY, hit);
      }
      assertEquals(List.of("0/0", "0/1", "0/2", "0/3", "1/0", "1/1", "1/2", "1/3"), met);
    }
  }

  /**
   * A system whose models shared one list of triangles moved them all when it moved one: here a
   * mesh at two places is one object, and what is done for one place changes nothing at another.
   */
  @Test
  void twoListsOneAddressMovingOneModelLeavesTheOtherWhereItIs() {
    Mesh mesh = tetrahedron(true);
    Placement here = Placement.of(mesh, Material.WHITE);
    double[] alone = pixels(Prepared.of(scene(40).place(here).build()));
    for (Transform away :
        List.of(
            Transform.translate(v(0, 0, 500)),
            Transform.scale(v(-0.1, 3, 0.2)).then(Transform.translate(v(0, 0, 500))))) {
      Scene both = scene(40).place(here).place(new Placement(mesh, away, Material.WHITE)).build();
      double[] together = pixels(Prepared.of(both));
      for (int i = 0; i < alone.length; i++) {
        assertEquals(alone[i], together[i], 1e-13);
      }
    }
    assertEquals(alone.length, pixels(Prepared.of(scene(40).place(here).build())).length);
  }

  @Test
  void theEyeMayBeInsideOfAnInstance() {
    Mesh mesh = tetrahedron(false);
    Scene.Builder scene =
        new Scene.Builder("inside")
            .size(8, 8)
            .camera(
                Camera.of(v(0.1, 0, 0), v(0, 0, -9), v(0, 1, 0), new Perspective(40, false, 0)));
    Transform around = Transform.scale(v(-2, 1, 1));
    scene.place(new Placement(mesh, around, GLASS));
    scene.place(new Placement(mesh, Transform.translate(v(0, 0, -20)), GLASS));
    assertEquals(1, Prepared.of(scene.build()).mediaAtEye().length);
    scene.place(new Placement(mesh, Transform.scale(v(3, 3, 3)), GLASS));
    assertEquals(2, Prepared.of(scene.build()).mediaAtEye().length);
  }

  @Test
  void meshesAtOnePlaceAndThoseTooFlatAreCarriedIntoTheWorld() {
    Mesh one = tetrahedron(false);
    Mesh other = tetrahedron(false);
    Scene.Builder scene = scene(8).place(Placement.of(one, Material.WHITE));
    Prepared apart = Prepared.of(scene.place(Placement.of(other, Material.WHITE)).build());
    assertFalse(apart.plan().instances().used());
    assertEquals(8, apart.primitiveCount());
    Transform flat = Transform.scale(v(1, 1, 1e-9));
    Prepared flatToo = Prepared.of(scene.place(new Placement(one, flat, Material.WHITE)).build());
    assertEquals(12, flatToo.primitiveCount());
    Prepared shared = Prepared.of(scene.place(Placement.of(one, Material.WHITE)).build());
    assertTrue(shared.plan().instances().used());
    assertTrue(shared.plan().tree().used());
    assertEquals(
        "meshes kept once, in their own space: 1; places: 2", shared.plan().instances().reason());
    assertEquals(2 + 4 + 4 + 4, shared.primitiveCount());
  }

  /** Of the scene and of what is made of it, everything that is still held. */
  @Test
  void anInstanceTakesLessThan300Bytes() {
    Material checked = Material.WHITE.textured(new Checker(0.5, Rgb.BLACK, Rgb.WHITE));
    NamedMaterial bark = new NamedMaterial("bark", checked);
    assertLight(tetrahedron(true), List.of(new NamedMaterial("bark", GLASS)));
    assertLight(
        tetrahedron(false).inParts(new int[] {0, 3}, new int[] {0, 1}), List.of(bark, bark));
  }

  private static void assertLight(Mesh mesh, List<NamedMaterial> materials) {
    int count = 50_000;
    List<Object> kept = new ArrayList<>();
    long before = heap();
    kept.add(forest(mesh, materials, count, kept));
    long bytes = heap() - before;
    assertTrue(bytes < 300L * count, (double) bytes / count + " bytes an instance");
    assertTrue(kept.size() == 2);
  }

  private static Prepared forest(
      Mesh mesh, List<NamedMaterial> materials, int count, List<Object> kept) {
    Random r = new Random(1);
    Scene.Builder scene = scene(8);
    for (int i = 0; i < count; i++) {
      Vector3d at = v(r.nextDouble(), 0, r.nextDouble()).times(StrictMath.sqrt(count));
      Transform place =
          Transform.scale(v(0.4, 0.5 + r.nextDouble(), 0.4))
              .then(Transform.rotate(Quaternion.aboutAxis(v(0, 1, 0), 360 * r.nextDouble())))
              .then(Transform.translate(at));
      scene.place(new Placement(mesh, place, materials, i));
    }
    Scene built = scene.build();
    kept.add(built);
    return Prepared.of(built);
  }

  private static long heap() {
    long used = Long.MAX_VALUE;
    for (int i = 0; i < 4; i++) {
      System.gc();
      long now = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
      used = Math.min(used, now);
    }
    return used;
  }
}
