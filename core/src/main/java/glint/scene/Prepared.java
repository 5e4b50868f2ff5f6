package glint.scene;

import glint.accel.Bvh;
import glint.accel.Intersector;
import glint.color.Rgb;
import glint.geometry.Primitives;
import glint.light.Illumination;
import glint.optics.Material;
import java.util.List;

/**
 * A scene in the form that rays touch, and the plan of what it needs; immutable, for all workers.
 */
public final class Prepared {

  private final Scene scene;
  private final RenderPlan plan;
  private final Illumination lights;
  private final Material[] materials;
  private final Primitives primitives;

  /** The tree over the primitives, or null where the plan does without. */
  private final Bvh tree;

  private final double radianceBound;

  private Prepared(Scene scene, Primitives primitives, Illumination lights, RenderPlan plan) {
    this.scene = scene;
    this.lights = lights;
    this.plan = plan;
    materials = scene.placements().stream().map(Placement::material).toArray(Material[]::new);
    tree = plan.tree().used() ? Bvh.over(primitives) : null;
    this.primitives = tree == null ? primitives : tree.primitives();
    radianceBound = boundRadiance();
  }

  /** Flattens a scene and decides what it needs. */
  public static Prepared of(Scene scene) {
    Primitives primitives = flatten(scene);
    Illumination lights = new Illumination(scene.lights());
    return new Prepared(scene, primitives, lights, RenderPlan.of(scene, primitives, lights));
  }

  /** Flattens a scene under a plan that must use at least what it needs. */
  public static Prepared of(Scene scene, RenderPlan plan) {
    return new Prepared(scene, flatten(scene), new Illumination(scene.lights()), plan);
  }

  private static Primitives flatten(Scene scene) {
    Primitives.Builder builder = new Primitives.Builder();
    List<Placement> placements = scene.placements();
    for (int i = 0; i < placements.size(); i++) {
      builder.add(placements.get(i).surface(), placements.get(i).toWorld(), i);
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

  /** Returns the material of a surface. */
  public Material material(int surface) {
    return materials[surface];
  }

  /** Returns the number of things that a ray can hit. */
  public int primitiveCount() {
    return primitives.count();
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
   * <p>With L the most that a surface or the background gives by itself and k the largest mirror
   * factor, a chain of mirrors gives at most L + kL + k²L + … = L / (1 - k).
   */
  public double radianceBound() {
    return radianceBound;
  }

  private double boundRadiance() {
    double own = Math.max(scene.background().down().max(), scene.background().up().max());
    double mirror = 0;
    Rgb light = lights.bound();
    for (Material m : materials) {
      Rgb local = m.emission().plus(m.ambient().times(lights.ambient()));
      Rgb answer = m.diffuse().plus(m.specular());
      own = Math.max(own, local.max() + (answer.isBlack() ? 0 : answer.max() * light.max()));
      mirror = Math.max(mirror, m.reflection().max());
    }
    return mirror < 1 ? own / (1 - mirror) : Double.POSITIVE_INFINITY;
  }
}
