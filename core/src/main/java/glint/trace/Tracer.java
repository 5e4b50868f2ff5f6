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
import glint.scene.Background;
import glint.scene.Prepared;
import glint.scene.RenderPlan;

/**
 * Computes the radiance that a ray brings back, after Whitted (1980); one per worker.
 *
 * <p>The model is written down in docs/shading.md. Everything mutable in here is scratch that is
 * used again for every ray.
 */
public final class Tracer {

  /**
   * The radiance below which a bounce is not followed: a twentieth of a display level where the
   * sRGB curve is steepest, 12.92 at black.
   */
  private static final double NEGLIGIBLE = 0.05 / (255 * 12.92);

  private final Prepared scene;
  private final RenderPlan plan;
  private final Illumination lights;
  private final int maxDepth;
  private final double least;

  private final Intersector intersector;
  private final Hit hit = new Hit();
  private final Hit blocker = new Hit();
  private final Ray shadowRay = new Ray();
  private final LightSample light = new LightSample();
  private final RayCounts counts = new RayCounts();

  /** The radiance found by the last call of {@link #trace}, linear. */
  public double r;

  public double g;
  public double b;

  /** The normal of the surface at the hit being shaded, on the side of the incoming ray. */
  private double nx;

  private double ny;
  private double nz;

  /**
   * Makes a tracer of its own scratch.
   *
   * @param maxDepth the most successive bounces
   */
  public Tracer(Prepared scene, int maxDepth) {
    this.scene = scene;
    this.plan = scene.plan();
    this.lights = scene.lights();
    this.intersector = scene.intersector();
    this.maxDepth = maxDepth;
    this.least = NEGLIGIBLE / scene.radianceBound();
  }

  /** Returns the rays traced so far. */
  public RayCounts counts() {
    return counts;
  }

  /**
   * Traces a camera ray and leaves its radiance in {@link #r}, {@link #g} and {@link #b}.
   *
   * @param ray of unit direction; overwritten
   * @param tMax where the far clipping plane ends it
   */
  public void trace(Ray ray, double tMax) {
    r = 0;
    g = 0;
    b = 0;
    counts.camera++;
    double weightR = 1;
    double weightG = 1;
    double weightB = 1;
    double end = tMax;
    for (int depth = 0; ; depth++) {
      counts.maxDepth = Math.max(counts.maxDepth, depth);
      intersector.closest(ray, end, hit);
      if (!hit.found()) {
        addBackground(ray, weightR, weightG, weightB);
        return;
      }
      resolve(ray);
      Material material = scene.material(hit.surface);
      addLocal(material, ray, weightR, weightG, weightB);
      if (!plan.mirrors().used() || depth == maxDepth || material.reflection().isBlack()) {
        return;
      }
      weightR *= material.reflection().r();
      weightG *= material.reflection().g();
      weightB *= material.reflection().b();
      if (!(Math.max(weightR, Math.max(weightG, weightB)) > least)) {
        return;
      }
      reflect(ray);
      end = Double.POSITIVE_INFINITY;
      counts.reflection++;
    }
  }

  /**
   * Finds what a camera ray sees first, without shading it.
   *
   * @return the hit, resolved if it was found
   */
  public Hit look(Ray ray, double tMax) {
    counts.camera++;
    intersector.closest(ray, tMax, hit);
    if (hit.found()) {
      resolve(ray);
    }
    return hit;
  }

  private void resolve(Ray ray) {
    intersector.resolve(ray, hit);
    // Turn the normal to the side that the ray comes from.
    boolean behind = ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz > 0;
    nx = behind ? -hit.nx : hit.nx;
    ny = behind ? -hit.ny : hit.ny;
    nz = behind ? -hit.nz : hit.nz;
  }

  private void addBackground(Ray ray, double weightR, double weightG, double weightB) {
    Background sky = scene.scene().background();
    Rgb up = sky.up();
    if (!plan.sky().used()) {
      r += weightR * up.r();
      g += weightG * up.g();
      b += weightB * up.b();
      return;
    }
    Rgb down = sky.down();
    double s = (1 + ray.dy) / 2;
    r += weightR * (down.r() + s * (up.r() - down.r()));
    g += weightG * (down.g() + s * (up.g() - down.g()));
    b += weightB * (down.b() + s * (up.b() - down.b()));
  }

  /** Adds what the surface gives by itself: emission, ambient light, and the lights it sees. */
  private void addLocal(
      Material material, Ray ray, double weightR, double weightG, double weightB) {
    Rgb emission = material.emission();
    Rgb ambient = material.ambient();
    Rgb everywhere = lights.ambient();
    double localR = emission.r() + ambient.r() * everywhere.r();
    double localG = emission.g() + ambient.g() * everywhere.g();
    double localB = emission.b() + ambient.b() * everywhere.b();
    if (plan.directLight().used()) {
      Rgb diffuse = material.diffuse();
      Rgb specular = material.specular();
      boolean shiny = plan.highlights().used() && !specular.isBlack();
      for (int i = 0; i < lights.count(); i++) {
        if (!lights.at(i, hit, light)) {
          continue;
        }
        double cos = nx * light.lx + ny * light.ly + nz * light.lz;
        if (!(cos > 0) || shadowed(i)) {
          continue;
        }
        double lobe = shiny ? highlight(ray, cos, material.shininess()) : 0;
        localR += light.r * (diffuse.r() * cos + specular.r() * lobe);
        localG += light.g * (diffuse.g() * cos + specular.g() * lobe);
        localB += light.b * (diffuse.b() * cos + specular.b() * lobe);
      }
    }
    r += weightR * localR;
    g += weightG * localG;
    b += weightB * localB;
  }

  private boolean shadowed(int i) {
    if (!plan.shadows().used()) {
      return false;
    }
    counts.shadow++;
    double end = lights.shadowRay(i, hit, shadowRay);
    return intersector.any(shadowRay, end, blocker);
  }

  /** Returns the highlight's lobe, 0 to 1, for the light in {@link #light} at {@code cos}. */
  private double highlight(Ray ray, double cos, double shininess) {
    counts.highlights++;
    double angle;
    if (scene.scene().highlight() == Highlight.BLINN) {
      double hx = light.lx - ray.dx;
      double hy = light.ly - ray.dy;
      double hz = light.lz - ray.dz;
      double h = Math.sqrt(hx * hx + hy * hy + hz * hz);
      angle = h > 0 ? (nx * hx + ny * hy + nz * hz) / h : 0;
    } else {
      double mx = 2 * cos * nx - light.lx;
      double my = 2 * cos * ny - light.ly;
      double mz = 2 * cos * nz - light.lz;
      angle = -(mx * ray.dx + my * ray.dy + mz * ray.dz);
    }
    return Lobe.of(Math.min(Math.max(angle, 0), 1), shininess);
  }

  /** Sets the ray to its mirror image about the normal, from the hit. */
  private void reflect(Ray ray) {
    double twice = 2 * (ray.dx * nx + ray.dy * ny + ray.dz * nz);
    double dx = ray.dx - twice * nx;
    double dy = ray.dy - twice * ny;
    double dz = ray.dz - twice * nz;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    hit.spawn(dx / length, dy / length, dz / length, ray);
  }
}
