package glint.trace;

import glint.accel.Intersector;
import glint.accel.Pencil;
import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.light.Illumination;
import glint.light.LightSample;
import glint.optics.Medium;
import glint.scene.Prepared;
import glint.scene.RenderPlan;
import java.util.Arrays;

/** The way from a place to a light, straight through everything transparent; scratch. */
final class ShadowRay {

  private final Prepared scene;
  private final RenderPlan plan;
  private final Illumination lights;
  private final Intersector intersector;
  private final RayCounts counts;
  private final Signature signature;
  private final Recorder recorder;
  private final Ray ray = new Ray();

  /** Where that ends: just before the light. */
  private double end;

  /** Which pencil it is of, or null. */
  private Pencil pencil;

  private final Hit blocker = new Hit();

  /** For each light the slot of what was in its way to the last point, or -1. */
  private final int[] blockers;

  private final Interior interior;
  private final Boundary boundary;

  /** The share of the light that passes, by channel, as the last call of {@link #reaches} found. */
  double passR;

  double passG;
  double passB;

  /** Counts rays, adds what they cross to a signature, and tells a recorder if that is not null. */
  ShadowRay(
      Prepared scene,
      Intersector intersector,
      RayCounts counts,
      Signature signature,
      Recorder recorder) {
    this.scene = scene;
    this.intersector = intersector;
    this.counts = counts;
    this.signature = signature;
    this.recorder = recorder;
    plan = scene.plan();
    lights = scene.lights();
    blockers = new int[lights.count()];
    Arrays.fill(blockers, -1);
    interior = new Interior(scene);
    boundary = new Boundary(scene, intersector);
  }

  /**
   * Follows the way from a hit to a light; returns whether anything passes.
   *
   * @param light what it sends
   * @param around the media at the hit
   */
  boolean reaches(int i, LightSample light, Hit hit, Interior around) {
    passR = 1;
    passG = 1;
    passB = 1;
    if (!plan.shadows().used()) {
      return true;
    }
    counts.shadow++;
    end = lights.shadowRay(i, light, hit, ray);
    pencil = scene.pencils().toLight(i);
    if (!plan.refraction().used()) {
      int slot = intersector.blocker(ray, end, pencil, blockers[i], blocker);
      if (recorder == null) {
        blockers[i] = slot;
      } else if (slot >= 0) { // what is told does not depend on other rays
        intersector.resolve(ray, blocker);
        recorder.crosses(blocker, blocker.surface, 0, Rgb.BLACK);
      }
      return slot < 0;
    }
    interior.copy(around);
    return walk();
  }

  /** Returns the number of what the way meets first of all that keeps light from passing. */
  int caster() {
    if (plan.refraction().used()) {
      return boundary.surface;
    }
    intersector.closest(ray, blocker.t, pencil, blocker);
    intersector.resolve(ray, blocker);
    return blocker.surface;
  }

  /** Walks through everything transparent, straight on, until something is opaque. */
  private boolean walk() {
    double dx = ray.dx;
    double dy = ray.dy;
    double dz = ray.dz;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    double from = 0;
    while (true) {
      intersector.closest(ray, end, pencil, blocker);
      if (!blocker.found()) {
        absorb((end - from) * length);
        return passes();
      }
      intersector.resolve(ray, blocker);
      scene.face(ray, blocker);
      interior.complete(blocker);
      double t = blocker.t;
      double cos = -(dx * blocker.sx + dy * blocker.sy + dz * blocker.sz) / length;
      boundary.meet(ray, end, blocker, interior);
      if (boundary.opaque) {
        if (recorder != null) {
          recorder.crosses(blocker, boundary.surface, 0, Rgb.BLACK);
        }
        return false;
      }
      if (boundary.visible) {
        signature.add(boundary.surface);
        absorb((t - from) * length);
        from = t;
        Rgb transparency = boundary.material().transparency();
        double reflected = boundary.shadowReflectance(Math.min(Math.max(cos, 0), 1));
        double through = 1 - reflected;
        passR *= transparency.r() * through;
        passG *= transparency.g() * through;
        passB *= transparency.b() * through;
        if (recorder != null) {
          recorder.crosses(blocker, boundary.surface, reflected, passing());
        }
      }
      interior.copy(boundary.beyond);
      if (!passes()) {
        return false;
      }
    }
  }

  /** Returns the share that passes. */
  Rgb passing() {
    return new Rgb(passR, passG, passB);
  }

  private boolean passes() {
    return passR > 0 || passG > 0 || passB > 0;
  }

  private void absorb(double length) {
    Medium medium = scene.medium(interior.current());
    if (medium.absorbs()) {
      passR *= medium.transmission(medium.absorption().r(), length);
      passG *= medium.transmission(medium.absorption().g(), length);
      passB *= medium.transmission(medium.absorption().b(), length);
    }
  }
}
