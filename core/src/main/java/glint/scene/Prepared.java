package glint.scene;

import glint.accel.Boxes;
import glint.accel.Bvh;
import glint.accel.Intersector;
import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Primitives;
import glint.geometry.Ray;
import glint.light.Illumination;
import glint.math.Vector3d;
import glint.optics.ImageTexture;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Texel;
import glint.optics.Texture;
import java.util.List;

/**
 * A scene in the form that rays touch, and the plan of what it needs; immutable, for all workers.
 */
public final class Prepared {

  /** In place of a medium: none, what is outside of everything. */
  public static final int OUTSIDE = -1;

  private final Scene scene;
  private final RenderPlan plan;
  private final Illumination lights;

  private final SurfaceTable surfaces;
  private final Primitives primitives;

  /** The tree over the primitives, or null where the plan does without. */
  private final Bvh tree;

  private final Pencils pencils;
  private final boolean smooth;
  private final double radianceBound;

  /** The media that the eye is inside of. */
  private final int[] mediaAtEye;

  private Prepared(
      Scene scene,
      RenderPlan plan,
      Illumination lights,
      SurfaceTable surfaces,
      Primitives primitives,
      Bvh tree,
      Pencils pencils) {
    this.scene = scene;
    this.plan = plan;
    this.lights = lights;
    this.surfaces = surfaces;
    this.primitives = primitives;
    this.tree = tree;
    this.pencils = pencils;
    smooth = plan.smoothNormals().used();
    radianceBound = boundRadiance();
    Vector3d eye = scene.camera().position();
    mediaAtEye =
        plan.refraction().used()
            ? new EyeMedia(this, primitives, intersector()).around(eye)
            : new int[0];
  }

  /** Flattens a scene and decides what it needs. */
  public static Prepared of(Scene scene) {
    Decision instances = RenderPlan.instances(scene);
    Primitives primitives = flatten(scene, instances);
    Illumination lights = new Illumination(scene.lights());
    RenderPlan plan = RenderPlan.of(scene, instances, primitives, lights);
    return of(scene, primitives, lights, plan);
  }

  /** Flattens a scene under a plan that must use at least what it needs. */
  public static Prepared of(Scene scene, RenderPlan plan) {
    Primitives primitives = flatten(scene, plan.instances());
    return of(scene, primitives, new Illumination(scene.lights()), plan);
  }

  private static Prepared of(
      Scene scene, Primitives primitives, Illumination lights, RenderPlan plan) {
    SurfaceTable surfaces = new SurfaceTable(scene.placements(), plan);
    Bvh tree = plan.tree().used() ? Bvh.over(primitives) : null;
    Primitives ordered = tree == null ? primitives : tree.primitives();
    Pencils pencils = Pencils.of(scene, plan, lights, ordered, tree);
    return new Prepared(scene, plan, lights, surfaces, ordered, tree, pencils);
  }

  /**
   * Returns the same for another picture of the same world, by another camera: nothing but what is
   * at the eye is found again.
   */
  public Prepared seenIn(Scene picture) {
    boolean same = same(picture.placements(), scene.placements());
    same &= same(picture.lights(), scene.lights());
    same &= picture.background().equals(scene.background());
    if (!same || picture.highlight() != scene.highlight()) {
      throw new IllegalArgumentException("another world");
    }
    Pencils other = pencils.seenIn(picture, plan, primitives);
    return new Prepared(picture, plan, lights, surfaces, primitives, tree, other);
  }

  private static boolean same(List<?> a, List<?> b) {
    boolean same = a.size() == b.size();
    for (int i = 0; same && i < a.size(); i++) {
      same = a.get(i) == b.get(i);
    }
    return same;
  }

  private static Primitives flatten(Scene scene, Decision instances) {
    SharedMeshes shared = new SharedMeshes(scene);
    Primitives.Builder builder = new Primitives.Builder();
    int surface = 0;
    for (Placement p : scene.placements()) {
      boolean inParts = p.materials().size() > 1;
      if (instances.used() && shared.isInstance(p)) {
        builder.show((Mesh) p.surface(), p.toWorld(), surface, inParts);
      } else {
        builder.add(p.surface(), p.toWorld(), surface, inParts);
      }
      if (p.isMoving()) {
        builder.move(surface, p.materials().size(), p.motion());
      }
      surface += p.materials().size();
    }
    return builder.build();
  }

  /** Returns the scene as it was written. */
  public Scene scene() {
    return scene;
  }

  /** Returns what is used and what is left out. */
  public RenderPlan plan() {
    return plan;
  }

  /** Returns the lights. */
  public Illumination lights() {
    return lights;
  }

  /** Returns the pencils that rays are of. */
  public Pencils pencils() {
    return pencils;
  }

  /** Returns how many surfaces there are. */
  public int surfaces() {
    return surfaces.count();
  }

  /** Returns the number, in the scene, of the placement that a surface is, or is a part of. */
  public int place(int surface) {
    return surfaces.place(surface);
  }

  /** Returns what the file calls the material of a surface, or "". */
  public String materialName(int surface) {
    return surfaces.materialName(surface);
  }

  /** Returns the material of a surface. */
  public Material material(int surface) {
    return surfaces.material(surface);
  }

  /** Sets a texel to what a surface's texture multiplies its colour by at a hit on it. */
  public void texture(int surface, Hit hit, Texel texel) {
    TexturedSurface textured = surfaces.texture(surface);
    if (textured == null) {
      texel.set(Rgb.WHITE, 0);
    } else {
      textured.at(hit, primitives, surfaces.placement(surface).toWorld(), texel);
    }
  }

  /** Returns the image on a surface, or null if there is none. */
  public ImageTexture image(int surface) {
    TexturedSurface textured = surfaces.texture(surface);
    return textured == null ? null : textured.image();
  }

  /**
   * Returns the number of the medium that a surface encloses, or {@link #OUTSIDE} if it encloses
   * none: if it is opaque or merely filters light. Not to be asked if the plan has no refraction.
   */
  public int mediumOf(int surface) {
    return surfaces.mediumOf(surface);
  }

  /** Returns whether a transparent surface is a sheet that encloses nothing by itself. */
  public boolean isOpen(int surface) {
    return surfaces.isOpen(surface);
  }

  /** Returns a medium by its number; outside it is vacuum. */
  public Medium medium(int number) {
    return number == OUTSIDE ? Medium.VACUUM : surfaces.medium(number);
  }

  /** Returns the media that the eye is inside of, outermost first; nobody may change the array. */
  public int[] mediaAtEye() {
    return mediaAtEye;
  }

  /** Turns the normals of a resolved hit to the side that a ray comes from. */
  public void face(Ray ray, Hit hit) {
    hit.face(ray);
    if (smooth) {
      Placement met = surfaces.placement(hit.surface);
      if (met.surface() instanceof Mesh mesh) {
        mesh.shade(primitives.triangle(hit), met.toWorld(), hit);
      }
    }
  }

  /** Returns what a ray can hit. */
  Primitives primitives() {
    return primitives;
  }

  /** Returns the number of things that a ray can hit, those of a shared mesh counted once. */
  public int primitiveCount() {
    return primitives.count() + primitives.models().stream().mapToInt(Primitives::count).sum();
  }

  /** Returns what the primitives and the tree over them take in memory. */
  public long geometryBytes() {
    return primitives.bytes() + (tree == null ? 0 : tree.bytes());
  }

  /** Returns a search for hits, for one worker. */
  public Intersector intersector() {
    return tree == null ? new Intersector(Boxes.around(primitives)) : new Intersector(tree);
  }

  /**
   * Returns an upper bound on the radiance of any ray, in any channel; infinite if there is none.
   *
   * <p>A surface that gives at most L by itself and passes on the share s of what it gets brings at
   * most L + sM back where nothing exceeds M: so M = L / (1 - s) is a bound if s &lt; 1, and so is
   * any M if L = 0 and s = 1. The largest of these and the background bounds all.
   */
  public double radianceBound() {
    return radianceBound;
  }

  private double boundRadiance() {
    double bound = Math.max(scene.background().down().max(), scene.background().up().max());
    bound = Math.max(bound, lights.brightestLamp());
    Rgb light = lights.bound();
    for (int surface = 0; surface < surfaces.count(); surface++) {
      Material m = surfaces.material(surface);
      Rgb most = m.texture().map(Texture::most).orElse(Rgb.WHITE);
      Rgb local = m.emission().plus(m.ambient().times(most).times(lights.ambient()));
      Rgb answer = m.diffuse().times(most).plus(m.specular());
      double given = local.max() + (answer.isBlack() ? 0 : answer.max() * light.max());
      double passed = m.reflection().plus(m.transparency()).max();
      if (passed > 1 || (passed == 1 && given > 0)) {
        return Double.POSITIVE_INFINITY;
      }
      bound = Math.max(bound, given == 0 ? 0 : given / (1 - passed));
    }
    return bound;
  }
}
