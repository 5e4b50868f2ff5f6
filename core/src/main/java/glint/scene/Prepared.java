package glint.scene;

import glint.accel.Bvh;
import glint.accel.Intersector;
import glint.color.Rgb;
import glint.geometry.Cylinder;
import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Primitives;
import glint.geometry.Quad;
import glint.geometry.Ray;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.light.Illumination;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Texel;
import glint.optics.Texture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A scene in the form that rays touch, and the plan of what it needs; immutable, for all workers.
 */
public final class Prepared {

  /** In place of a medium: none, what is outside of everything. */
  public static final int OUTSIDE = -1;

  private final Scene scene;
  private final RenderPlan plan;
  private final Illumination lights;

  /**
   * For each surface the number of its placement; empty if none is in parts, which are surfaces.
   */
  private final int[] place;

  private final Material[] materials;

  /** The textures of the surfaces, null where there is none; empty if no surface has one. */
  private final TexturedSurface[] textures;

  /** The different media of the scene. */
  private final List<Medium> media = new ArrayList<>();

  /** For each surface the number of its medium; empty if no light goes through any. */
  private final int[] mediumOf;

  /** For each surface that lets light through, or a part of which does, whether it is a sheet. */
  private final boolean[] open;

  private final Primitives primitives;

  /** The tree over the primitives, or null where the plan does without. */
  private final Bvh tree;

  private final boolean smooth;
  private final double radianceBound;

  /** The media that the eye is inside of. */
  private final int[] mediaAtEye;

  private Prepared(Scene scene, Primitives primitives, Illumination lights, RenderPlan plan) {
    this.scene = scene;
    this.lights = lights;
    this.plan = plan;
    int count = scene.placements().stream().mapToInt(p -> p.materials().size()).sum();
    place = new int[count > scene.placements().size() ? count : 0];
    materials = new Material[count];
    textures = new TexturedSurface[plan.textures().used() ? count : 0];
    mediumOf = new int[plan.refraction().used() ? count : 0];
    open = new boolean[mediumOf.length];
    Map<Mesh, Boolean> closed = new HashMap<>();
    int first = 0;
    for (int i = 0; i < scene.placements().size(); i++) {
      first = number(i, first, closed);
    }
    smooth = plan.smoothNormals().used();
    tree = plan.tree().used() ? Bvh.over(primitives) : null;
    this.primitives = tree == null ? primitives : tree.primitives();
    radianceBound = boundRadiance();
    Vector3d eye = scene.camera().position();
    mediaAtEye =
        plan.refraction().used()
            ? new EyeMedia(this, this.primitives, intersector()).around(eye)
            : new int[0];
  }

  /** Numbers the surfaces of a placement from the first on; returns the number after its last. */
  private int number(int placement, int first, Map<Mesh, Boolean> closed) {
    Placement p = scene.placements().get(placement);
    boolean sheet = p.any(Material::isTransparent) && isSheet(p.surface(), closed);
    int surface = first;
    for (NamedMaterial named : p.materials()) {
      if (place.length > 0) {
        place[surface] = placement;
      }
      materials[surface] = named.material();
      if (textures.length > 0) {
        textures[surface] = TexturedSurface.of(p, named.material());
      }
      if (mediumOf.length > 0) {
        mediumOf[surface] = mediumNumber(named.material());
        open[surface] = sheet;
      }
      surface++;
    }
    return surface;
  }

  /** Flattens a scene and decides what it needs. */
  public static Prepared of(Scene scene) {
    Decision instances = RenderPlan.instances(scene);
    Primitives primitives = flatten(scene, instances);
    Illumination lights = new Illumination(scene.lights());
    RenderPlan plan = RenderPlan.of(scene, instances, primitives, lights);
    return new Prepared(scene, primitives, lights, plan);
  }

  /** Flattens a scene under a plan that must use at least what it needs. */
  public static Prepared of(Scene scene, RenderPlan plan) {
    Primitives primitives = flatten(scene, plan.instances());
    return new Prepared(scene, primitives, new Illumination(scene.lights()), plan);
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

  /** Returns how many surfaces there are. */
  public int surfaces() {
    return materials.length;
  }

  /** Returns the number, in the scene, of the placement that a surface is, or is a part of. */
  public int place(int surface) {
    return place.length > 0 ? place[surface] : surface;
  }

  /** Returns what the file calls the material of a surface, or "". */
  public String materialName(int surface) {
    int part = 0;
    while (part < surface && place(surface - part - 1) == place(surface)) {
      part++;
    }
    return scene.placements().get(place(surface)).materials().get(part).name();
  }

  /** Returns the material of a surface. */
  public Material material(int surface) {
    return materials[surface];
  }

  /** Sets a texel to what a surface's texture multiplies its colour by at a hit on it. */
  public void texture(int surface, Hit hit, Texel texel) {
    TexturedSurface textured = textures.length > 0 ? textures[surface] : null;
    if (textured == null) {
      texel.set(Rgb.WHITE);
    } else {
      textured.at(hit, primitives, texel);
    }
  }

  /**
   * Returns the number of the medium that a surface encloses, or {@link #OUTSIDE} if it encloses
   * none: if it is opaque or merely filters light. Not to be asked if the plan has no refraction.
   */
  public int mediumOf(int surface) {
    return mediumOf[surface];
  }

  /** Returns whether a transparent surface is a sheet that encloses nothing by itself. */
  public boolean isOpen(int surface) {
    return open[surface];
  }

  private static boolean isSheet(Surface shape, Map<Mesh, Boolean> closed) {
    return shape instanceof Triangle
        || shape instanceof Quad
        || (shape instanceof Cylinder c && !c.capped())
        || (shape instanceof Mesh m && !closed.computeIfAbsent(m, Mesh::isClosed));
  }

  /** Returns a medium by its number; outside it is vacuum. */
  public Medium medium(int number) {
    return number == OUTSIDE ? Medium.VACUUM : media.get(number);
  }

  private int mediumNumber(Material material) {
    Medium interior = material.interior();
    if (!material.isTransparent() || interior.isVacuum()) {
      return OUTSIDE;
    }
    if (!media.contains(interior)) {
      media.add(interior);
    }
    return media.indexOf(interior);
  }

  /** Returns the media that the eye is inside of, outermost first; nobody may change the array. */
  public int[] mediaAtEye() {
    return mediaAtEye;
  }

  /** Turns the normals of a resolved hit to the side that a ray comes from. */
  public void face(Ray ray, Hit hit) {
    hit.face(ray);
    if (smooth) {
      Placement met = scene.placements().get(place(hit.surface));
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
    return tree == null ? new Intersector(primitives) : new Intersector(tree);
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
    for (Material m : materials) {
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
