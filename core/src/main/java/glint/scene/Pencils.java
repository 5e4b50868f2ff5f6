package glint.scene;

import glint.accel.Pencil;
import glint.geometry.Primitives;
import glint.light.Illumination;

/** The pencils that the rays of a scene are of; immutable, for all workers. */
public final class Pencils {

  /** Of more bounded primitives than so many, few lists would be short. */
  private static final int MOST = 1 << 14;

  /** No more lights have lists, which take 200 kB at most. */
  private static final int MOST_LIGHTS = 64;

  private final Pencil fromEye;
  private final Pencil[] toLights;

  private Pencils(Pencil fromEye, Pencil[] toLights) {
    this.fromEye = fromEye;
    this.toLights = toLights;
  }

  /** Decides whether a scene has any that pay. */
  static Decision decide(Scene scene, Illumination lights, Primitives primitives) {
    String feature = "pencils";
    int bounded = primitives.count() - primitives.unbounded();
    if (bounded < 2 || bounded > MOST) {
      String which = bounded < 2 ? "rays have no choice" : "too much for short lists";
      return new Decision(feature, false, which + ": " + bounded + " bounded primitives");
    }
    boolean sharp = !RenderPlan.lens(scene).used();
    boolean shadows = RenderPlan.shadows(scene, lights).used();
    int points = shadows ? Math.min(lights.count() - lights.lamps(), MOST_LIGHTS) : 0;
    if (!sharp && points == 0) {
      return new Decision(feature, false, "no rays begin or end at one place");
    }
    String which = "to lights: " + points + (sharp ? ", and from the eye" : "");
    return new Decision(feature, true, "lists of what rays can meet: " + which);
  }

  /** Makes what a plan uses. */
  static Pencils of(Scene scene, RenderPlan plan, Illumination lights, Primitives primitives) {
    Pencil[] toLights = new Pencil[lights.count()];
    if (plan.pencils().used() && plan.shadows().used()) {
      int made = 0;
      for (int i = 0; i < toLights.length && made < MOST_LIGHTS; i++) {
        toLights[i] = lights.pencil(i, primitives);
        made += toLights[i] == null ? 0 : 1;
      }
    }
    return new Pencils(fromEye(scene, plan, primitives), toLights);
  }

  /** Returns the same for another picture of the same world. */
  Pencils seenIn(Scene picture, RenderPlan plan, Primitives primitives) {
    return new Pencils(fromEye(picture, plan, primitives), toLights);
  }

  private static Pencil fromEye(Scene scene, RenderPlan plan, Primitives primitives) {
    Camera camera = scene.camera();
    if (!plan.pencils().used() || RenderPlan.lens(scene).used()) {
      return null;
    }
    return camera.projection() instanceof Orthographic
        ? Pencil.along(camera.forward(), primitives)
        : Pencil.from(camera.position(), primitives);
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
