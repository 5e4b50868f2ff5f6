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
import glint.optics.Texel;
import glint.sampling.SobolSampler;
import glint.scene.Prepared;
import glint.scene.RenderPlan;
import glint.trace.RayTree.Fate;

/** What a surface gives by itself: emission, ambient light, and the lights that reach it. */
final class DirectLight {

  private final Prepared scene;
  private final RenderPlan plan;
  private final Illumination lights;
  private final RayCounts counts;
  private final Signature signature;
  private final LightSample light = new LightSample();
  private final ShadowRay shadow;

  /** Is told of every light; null unless somebody asks. */
  private final Recorder recorder;

  /** What was found by the last call of {@link #find}. */
  double r;

  double g;
  double b;

  /** Is told of shadows; null unless somebody asks. */
  Veil veil;

  /** Is told of the image on the surface; null unless somebody asks. */
  Print print;

  /** What the surface's texture multiplies its colour by. */
  final Texel pattern = new Texel();

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
    this.counts = counts;
    this.signature = signature;
    shadow = new ShadowRay(scene, intersector, counts, signature, recorder);
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
      if (print != null && pattern.isOfImage) {
        print.begin(scene.image(surface), pattern);
      } else {
        signature.add(pattern);
      }
    }
    Rgb emission = material.emission();
    Rgb ambient = material.ambient();
    Rgb everywhere = lights.ambient();
    r = emission.r() + ambient.r() * pattern.r * everywhere.r();
    g = emission.g() + ambient.g() * pattern.g * everywhere.g();
    b = emission.b() + ambient.b() * pattern.b * everywhere.b();
    if (print != null) {
      print.add(
          ambient.r() * everywhere.r(), ambient.g() * everywhere.g(), ambient.b() * everywhere.b());
    }
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
    if (!shadow.reaches(i, light, hit, around)) {
      tell(i, Fate.SHADOWED, cos, 0, 0, 0);
      if (veil != null) {
        veil.add(i, shadow.caster(), light, material, pattern, cos);
      }
      return;
    }
    Rgb diffuse = material.diffuse();
    Rgb specular = material.specular();
    signature.add(i);
    boolean shiny = plan.highlights().used() && !specular.isBlack();
    double lobe = shiny ? highlight(hit, ray, cos, material.shininess()) : 0;
    double addR = shadow.passR * (light.r * (diffuse.r() * pattern.r * cos + specular.r() * lobe));
    double addG = shadow.passG * (light.g * (diffuse.g() * pattern.g * cos + specular.g() * lobe));
    double addB = shadow.passB * (light.b * (diffuse.b() * pattern.b * cos + specular.b() * lobe));
    r += addR;
    g += addG;
    b += addB;
    if (print != null) {
      print.add(
          shadow.passR * light.r * diffuse.r() * cos,
          shadow.passG * light.g * diffuse.g() * cos,
          shadow.passB * light.b * diffuse.b() * cos);
    }
    tell(i, Fate.LIT, cos, addR, addG, addB);
  }

  private void tell(int i, Fate fate, double cos, double addR, double addG, double addB) {
    if (recorder != null) {
      Rgb added = new Rgb(addR, addG, addB);
      recorder.lights(lights.number(i), fate, light, cos, shadow.passing(), added);
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
