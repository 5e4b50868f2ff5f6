package glint.trace;

import glint.light.LightSample;
import glint.optics.Material;
import glint.optics.Texel;

/**
 * What shadows keep from the place that a camera ray meets first, and what casts them.
 *
 * <p>Between two places of a flat surface where one convex thing casts the shadow there is shadow.
 * Where it is not the same thing, light may fall between.
 */
public final class Veil {

  /** The light that would be reflected but for the shadows, linear; highlights are left out. */
  public double r;

  public double g;
  public double b;

  private final Signature casters = new Signature();

  void clear() {
    r = 0;
    g = 0;
    b = 0;
    casters.clear();
  }

  /**
   * Adds the shadow from one light.
   *
   * @param caster the number of the surface that is in the way, first from where the shadow is
   */
  void add(int light, int caster, LightSample sent, Material material, Texel pattern, double cos) {
    r += sent.r * material.diffuse().r() * pattern.r * cos;
    g += sent.g * material.diffuse().g() * pattern.g * cos;
    b += sent.b * material.diffuse().b() * pattern.b * cos;
    casters.add(light);
    casters.add(caster);
  }

  /** Returns in one number which surfaces keep which lights away; 0 if none does. */
  public long casters() {
    return casters.value();
  }
}
