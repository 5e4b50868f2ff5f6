package glint.scene;

import glint.accel.Bvh;
import glint.accel.Parts;
import glint.accel.Pencil;
import glint.geometry.Primitives;
import glint.light.Illumination;

/** The pencils that the rays of a scene are of; immutable, for all workers. */
public final class Pencils {

  /** Of more bounded primitives than so many, lists are of subtrees that hold them. */
  private static final int MOST = 1 << 14;

  /** Of so many, few, a light's lists take 1.6 MB at most, of more 6.3 MB. */
  private static final int FEW = 256;

  // No more lights have lists, of few primitives and of many.
  private static final int MOST_LIGHTS = 64;
  private static final int MOST_LIGHTS_OF_MANY = 8;

  /** What lists are of in place of primitives, or null. */
  private final Parts parts;

  private final Pencil fromEye;
  private final Pencil[] toLights;

  private Pencils(Parts parts, Pencil fromEye, Pencil[] toLights) {
    this.parts = parts;
    this.fromEye = fromEye;
    this.toLights = toLights;
  }

  /** Decides whether a scene has any that pay. */
  static Decision decide(Scene scene, Illumination lights, Primitives primitives) {
    String feature = "pencils";
    int bounded = primitives.count() - primitives.unbounded();
    boolean instanced = bounded > MOST && !primitives.models().isEmpty();
    if (bounded < 2 || instanced) { // lists would take more memory than so many instances may
      String which = bounded < 2 ? "rays have no choice" : "too much for short lists";
      return new Decision(feature, false, which + ": " + bounded + " bounded primitives");
    }
    boolean sharp = !RenderPlan.lens(scene).used();
    boolean shadows = RenderPlan.shadows(scene, lights).used();
    int points = shadows ? Math.min(lights.count() - lights.lamps(), mostLights(bounded)) : 0;
    if (!sharp && points == 0) {
      return new Decision(feature, false, "no rays begin or end at one place");
    }
    String which = "to lights: " + points + (sharp ? ", and from the eye" : "");
    return new Decision(feature, true, "lists of what rays can meet: " + which);
  }

  private static int mostLights(int bounded) {
    return bounded > FEW ? MOST_LIGHTS_OF_MANY : MOST_LIGHTS;
  }

  /** Makes what a plan uses. */
  static Pencils of(
      Scene scene, RenderPlan plan, Illumination lights, Primitives primitives, Bvh tree) {
    int bounded = primitives.count() - primitives.unbounded();
    Parts parts = plan.pencils().used() && bounded > MOST ? Parts.of(tree) : null;
    Pencil[] toLights = new Pencil[lights.count()];
    if (plan.pencils().used() && plan.shadows().used()) {
      int made = 0;
      for (int i = 0; i < toLights.length && made < mostLights(bounded); i++) {
        toLights[i] = lights.pencil(i, primitives, parts);
        made += toLights[i] == null ? 0 : 1;
      }
    }
    return new Pencils(parts, fromEye(scene, plan, primitives, parts), toLights);
  }

  /** Returns the same for another picture of the same world. */
  Pencils seenIn(Scene picture, RenderPlan plan, Primitives primitives) {
    return new Pencils(parts, fromEye(picture, plan, primitives, parts), toLights);
  }

  private static Pencil fromEye(Scene scene, RenderPlan plan, Primitives primitives, Parts parts) {
    Camera camera = scene.camera();
    if (!plan.pencils().used() || RenderPlan.lens(scene).used()) {
      return null;
    }
    return camera.projection() instanceof Orthographic
        ? Pencil.along(camera.forward(), primitives, parts)
        : Pencil.from(camera.position(), primitives, parts);
  }

  /** Returns the camera's rays, or null where each starts somewhere else or it does not pay. */
  public Pencil fromEye() {
    return fromEye;
  }

  /** Returns the shadow rays to a light, or null where each ends somewhere else. */
  public Pencil toLight(int i) {
    return toLights[i];
  }
}
