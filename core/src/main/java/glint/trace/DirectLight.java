package glint.trace;

import glint.accel.Intersector;
import glint.accel.Pencil;
import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.light.Illumination;
import glint.light.LightSample;
import glint.optics.Highlight;
import glint.optics.Lobe;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Texel;
import glint.sampling.SobolSampler;
import glint.scene.Prepared;
import glint.scene.RenderPlan;
import glint.trace.RayTree.Fate;
import java.util.Arrays;

/** What a surface gives by itself: emission, ambient light, and the lights that reach it. */
final class DirectLight {

  private final Prepared scene;
  private final RenderPlan plan;
  private final Illumination lights;
  private final Intersector intersector;
  private final RayCounts counts;
  private final Signature signature;
  private final Ray shadowRay = new Ray();

  /** Where that ends: just before the light. */
  private double end;

  /** Which pencil it is of, or null. */
  private Pencil pencil;

  private final Hit blocker = new Hit();

  /** For each light the slot of what was in its way to the last point, or -1. */
  private final int[] blockers;

  private final LightSample light = new LightSample();
  private final Interior interior;
  private final Boundary boundary;

  /** Is told of every light; null unless somebody asks. */
  private final Recorder recorder;

  /** What was found by the last call of {@link #find}. */
  double r;

  double g;
  double b;

  /** Is told of shadows; null unless somebody asks. */
  Veil veil;

  /** What the surface's texture multiplies its colour by. */
  private final Texel pattern = new Texel();

  /** The share of the light that passes on the way to it, by channel. */
  private double passR;

  private double passG;
  private double passB;

  DirectLight(
      Prepared scene,
      Intersector intersector,
      RayCounts counts,
      Signature signature,
      Recorder recorder) {
    this.scene = scene;
    this.recorder = recorder;
    this.plan = scene.plan();
    this.lights = scene.lights();
    this.intersector = intersector;
    this.counts = counts;
    this.signature = signature;
    blockers = new int[lights.count()];
    Arrays.fill(blockers, -1);
    interior = new Interior(scene);
    boundary = new Boundary(scene, intersector);
    pattern.set(Rgb.WHITE);
  }

  /**
   * Finds what a surface gives towards a ray.
   *
   * @param surface its number
   * @param hit where it is met, its normal facing the ray
   * @param around the media on the ray's side
   * @param numbers decide which places of lamps are taken
   * @param path the number of the ray in its tree
   */
  void find(int surface, Hit hit, Ray ray, Interior around, SobolSampler numbers, long path) {
    Material material = scene.material(surface);
    if (plan.textures().used()) {
      scene.texture(surface, hit, pattern);
      signature.add(pattern);
    }
    Rgb emission = material.emission();
    Rgb ambient = material.ambient();
    Rgb everywhere = lights.ambient();
    r = emission.r() + ambient.r() * pattern.r * everywhere.r();
    g = emission.g() + ambient.g() * pattern.g * everywhere.g();
    b = emission.b() + ambient.b() * pattern.b * everywhere.b();
    if (recorder != null) {
      recorder.glows(pattern.color(), r, g, b);
    }
    boolean dull = material.specular().isBlack() || !plan.highlights().used();
    if (!plan.directLight().used() || (dull && material.diffuse().isBlack())) {
      return;
    }
    for (int i = 0; i < lights.count(); i++) {
      boolean sends = lights.at(i, hit, numbers, path, light);
      answer(i, sends, material, hit, ray, around);
    }
  }

  /** Adds what the surface gives for one light. */
  private void answer(int i, boolean sends, Material material, Hit hit, Ray ray, Interior around) {
    if (!sends) {
      tell(i, Fate.DARK, 0, 0, 0, 0);
      return;
    }
    double cos = hit.sx * light.lx + hit.sy * light.ly + hit.sz * light.lz;
    if (!(cos > 0)) {
      tell(i, Fate.BEHIND, cos, 0, 0, 0);
      return;
    }
    if (!reaches(i, hit, around)) {
      tell(i, Fate.SHADOWED, cos, 0, 0, 0);
      if (veil != null) {
        veil.add(i, caster(), light, material, pattern, cos);
      }
      return;
    }
    Rgb diffuse = material.diffuse();
    Rgb specular = material.specular();
    signature.add(i);
    boolean shiny = plan.highlights().used() && !specular.isBlack();
    double lobe = shiny ? highlight(hit, ray, cos, material.shininess()) : 0;
    double addR = passR * (light.r * (diffuse.r() * pattern.r * cos + specular.r() * lobe));
    double addG = passG * (light.g * (diffuse.g() * pattern.g * cos + specular.g() * lobe));
    double addB = passB * (light.b * (diffuse.b() * pattern.b * cos + specular.b() * lobe));
    r += addR;
    g += addG;
    b += addB;
    tell(i, Fate.LIT, cos, addR, addG, addB);
  }

  private void tell(int i, Fate fate, double cos, double addR, double addG, double addB) {
    if (recorder != null) {
      Rgb added = new Rgb(addR, addG, addB);
      recorder.lights(lights.number(i), fate, light, cos, passing(), added);
    }
  }

  /** Follows the way to a light; returns whether anything passes, and how much. */
  private boolean reaches(int i, Hit hit, Interior around) {
    passR = 1;
    passG = 1;
    passB = 1;
    if (!plan.shadows().used()) {
      return true;
    }
    counts.shadow++;
    end = lights.shadowRay(i, light, hit, shadowRay);
    pencil = scene.pencils().toLight(i);
    if (!plan.refraction().used()) {
      int slot = intersector.blocker(shadowRay, end, pencil, blockers[i], blocker);
      if (recorder == null) {
        blockers[i] = slot;
      } else if (slot >= 0) { // what is told does not depend on other rays
        intersector.resolve(shadowRay, blocker);
        recorder.crosses(blocker, blocker.surface, 0, Rgb.BLACK);
      }
      return slot < 0;
    }
    interior.copy(around);
    return walk();
  }

  /** Returns what the way to the light meets first of what keeps it from passing. */
  private int caster() {
    if (plan.refraction().used()) {
      return boundary.surface;
    }
    intersector.closest(shadowRay, blocker.t, pencil, blocker);
    intersector.resolve(shadowRay, blocker);
    return blocker.surface;
  }

  /** Walks through everything transparent, straight on, until something is opaque. */
  private boolean walk() {
    double dx = shadowRay.dx;
    double dy = shadowRay.dy;
    double dz = shadowRay.dz;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    double from = 0;
    while (true) {
      intersector.closest(shadowRay, end, pencil, blocker);
      if (!blocker.found()) {
        absorb((end - from) * length);
        return passes();
      }
      intersector.resolve(shadowRay, blocker);
      scene.face(shadowRay, blocker);
      interior.complete(blocker);
      double t = blocker.t;
      double cos = -(dx * blocker.sx + dy * blocker.sy + dz * blocker.sz) / length;
      boundary.meet(shadowRay, end, blocker, interior);
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

  private Rgb passing() {
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

  /** Returns the highlight's lobe, 0 to 1, for the light in {@link #light} at {@code cos}. */
  private double highlight(Hit hit, Ray ray, double cos, double shininess) {
    counts.highlights++;
    double angle;
    if (scene.scene().highlight() == Highlight.BLINN) {
      double hx = light.lx - ray.dx;
      double hy = light.ly - ray.dy;
      double hz = light.lz - ray.dz;
      double h = Math.sqrt(hx * hx + hy * hy + hz * hz);
      angle = h > 0 ? (hit.sx * hx + hit.sy * hy + hit.sz * hz) / h : 0;
    } else {
      double mx = 2 * cos * hit.sx - light.lx;
      double my = 2 * cos * hit.sy - light.ly;
      double mz = 2 * cos * hit.sz - light.lz;
      angle = -(mx * ray.dx + my * ray.dy + mz * ray.dz);
    }
    return Lobe.of(Math.min(Math.max(angle, 0), 1), shininess);
  }
}
