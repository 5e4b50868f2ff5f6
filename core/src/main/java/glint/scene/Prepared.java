package glint.scene;

import glint.accel.LinearScan;
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
  private final LinearScan search;
  private final double radianceBound;

  private Prepared(Scene scene, RenderPlan plan, Illumination lights) {
    this.scene = scene;
    this.plan = plan;
    this.lights = lights;
    List<Placement> placements = scene.placements();
    materials = new Material[placements.size()];
    Primitives.Builder builder = new Primitives.Builder();
    for (int i = 0; i < materials.length; i++) {
      Placement p = placements.get(i);
      materials[i] = p.material();
      builder.add(p.surface(), p.toWorld(), i);
    }
    primitives = builder.build();
    search = new LinearScan(primitives);
    radianceBound = boundRadiance();
  }

  /** Flattens a scene and decides what it needs. */
  public static Prepared of(Scene scene) {
    Illumination lights = new Illumination(scene.lights());
    return new Prepared(scene, RenderPlan.of(scene, lights), lights);
  }

  /** Flattens a scene under a plan that must use at least what it needs. */
  public static Prepared of(Scene scene, RenderPlan plan) {
    return new Prepared(scene, plan, new Illumination(scene.lights()));
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

  /** Returns the primitives. */
  public Primitives primitives() {
    return primitives;
  }

  /** Returns the search for hits. */
  public LinearScan search() {
    return search;
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
