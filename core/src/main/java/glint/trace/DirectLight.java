package glint.trace;

import glint.accel.Intersector;
import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.light.Illumination;
import glint.light.LightSample;
import glint.optics.Highlight;
import glint.optics.Lobe;
import glint.optics.Material;
import glint.optics.Medium;
import glint.scene.Prepared;
import glint.scene.RenderPlan;

/** What a surface gives by itself: emission, ambient light, and the lights that reach it. */
final class DirectLight {

  private final Prepared scene;
  private final RenderPlan plan;
  private final Illumination lights;
  private final Intersector intersector;
  private final RayCounts counts;
  private final Ray shadowRay = new Ray();
  private final Hit blocker = new Hit();
  private final LightSample light = new LightSample();
  private final Interior interior;
  private final Boundary boundary;

  /** What was found by the last call of {@link #find}. */
  double r;

  double g;
  double b;

  /** The share of the light that passes on the way to it, by channel. */
  private double passR;

  private double passG;
  private double passB;

  DirectLight(Prepared scene, Intersector intersector, RayCounts counts) {
    this.scene = scene;
    this.plan = scene.plan();
    this.lights = scene.lights();
    this.intersector = intersector;
    this.counts = counts;
    interior = new Interior(scene);
    boundary = new Boundary(scene, intersector);
  }

  /**
   * Finds what a surface gives towards a ray.
   *
   * @param hit where it is met, its normal facing the ray
   * @param around the media on the ray's side
   */
  void find(Material material, Hit hit, Ray ray, Interior around) {
    Rgb emission = material.emission();
    Rgb ambient = material.ambient();
    Rgb everywhere = lights.ambient();
    r = emission.r() + ambient.r() * everywhere.r();
    g = emission.g() + ambient.g() * everywhere.g();
    b = emission.b() + ambient.b() * everywhere.b();
    Rgb diffuse = material.diffuse();
    Rgb specular = material.specular();
    boolean shiny = plan.highlights().used() && !specular.isBlack();
    if (!plan.directLight().used() || (!shiny && diffuse.isBlack())) {
      return;
    }
    for (int i = 0; i < lights.count(); i++) {
      if (!lights.at(i, hit, light)) {
        continue;
      }
      double cos = hit.nx * light.lx + hit.ny * light.ly + hit.nz * light.lz;
      if (!(cos > 0) || !reaches(i, hit, around)) {
        continue;
      }
      double lobe = shiny ? highlight(hit, ray, cos, material.shininess()) : 0;
      r += passR * (light.r * (diffuse.r() * cos + specular.r() * lobe));
      g += passG * (light.g * (diffuse.g() * cos + specular.g() * lobe));
      b += passB * (light.b * (diffuse.b() * cos + specular.b() * lobe));
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
    double end = lights.shadowRay(i, hit, shadowRay);
    if (!plan.refraction().used()) {
      return !intersector.any(shadowRay, end, blocker);
    }
    interior.copy(around);
    return passes(end);
  }

  /** Walks through everything transparent, straight on, until something is opaque. */
  private boolean passes(double end) {
    double dx = shadowRay.dx;
    double dy = shadowRay.dy;
    double dz = shadowRay.dz;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    double from = 0;
    while (true) {
      intersector.closest(shadowRay, end, blocker);
      if (!blocker.found()) {
        absorb((end - from) * length);
        return passes();
      }
      intersector.resolve(shadowRay, blocker);
      blocker.face(shadowRay);
      interior.complete(blocker);
      double t = blocker.t;
      double cos = Math.abs(dx * blocker.nx + dy * blocker.ny + dz * blocker.nz) / length;
      boundary.meet(shadowRay, end, blocker, interior);
      if (boundary.opaque) {
        return false;
      }
      if (boundary.visible) {
        absorb((t - from) * length);
        from = t;
        Rgb transparency = boundary.material().transparency();
        double through = 1 - boundary.shadowReflectance(Math.min(cos, 1));
        passR *= transparency.r() * through;
        passG *= transparency.g() * through;
        passB *= transparency.b() * through;
      }
      interior.copy(boundary.beyond);
      if (!passes()) {
        return false;
      }
    }
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
      angle = h > 0 ? (hit.nx * hx + hit.ny * hy + hit.nz * hz) / h : 0;
    } else {
      double mx = 2 * cos * hit.nx - light.lx;
      double my = 2 * cos * hit.ny - light.ly;
      double mz = 2 * cos * hit.nz - light.lz;
      angle = -(mx * ray.dx + my * ray.dy + mz * ray.dz);
    }
    return Lobe.of(Math.min(Math.max(angle, 0), 1), shininess);
  }
}
