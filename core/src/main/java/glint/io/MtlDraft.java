package glint.io;

import glint.color.Rgb;
import glint.optics.Material;
import glint.optics.Medium;
import java.util.Optional;

/**
 * A material of an MTL file while it is read: what is written of it, and what that means.
 *
 * <p>Illumination models are those of the Advanced Visualizer Manual; docs/scene-format.md has the
 * table. Null is what is not written.
 */
final class MtlDraft {

  /** The model of who states none: colour, ambient light and highlights. */
  static final int USUAL_MODEL = 2;

  static final int LAST_MODEL = 10;

  Rgb ambient;
  Rgb diffuse;
  Rgb specular = Rgb.BLACK;
  Rgb emission = Rgb.BLACK;
  Rgb filter = Rgb.WHITE;
  double shininess = 32;
  double index = 1;

  /** What is written as d, the share that is opaque, and as Tr, the share that is not. */
  Double dissolve;

  Double transparency;

  int model = USUAL_MODEL;
  MtlMap map;

  /** Returns the material that this describes. */
  MtlMaterial finish() {
    return new MtlMaterial(
        material(), leavesOutMap() ? Optional.empty() : Optional.ofNullable(map));
  }

  /** Returns whether what is written as d and Tr cannot both be meant. */
  boolean contradictsItself() {
    boolean both = dissolve != null && transparency != null;
    return both && Math.abs(dissolve + transparency - 1) > 1e-3; // both are written with few digits
  }

  /** Returns whether there is an image, but nothing that it could multiply. */
  boolean leavesOutMap() {
    return model == 0 && map != null;
  }

  private Material material() {
    double opaque = opaque();
    Rgb through = through(opaque);
    Rgb mirrored = mirrors() ? specular : Rgb.BLACK;
    boolean otherwiseLit = !(through.isBlack() && mirrored.isBlack() && emission.isBlack());
    Rgb own = diffuse != null ? diffuse : otherwiseLit && map == null ? Rgb.BLACK : Rgb.WHITE;
    Rgb inAmbient = ambient != null ? ambient : own;
    boolean unlit = model == 0;
    return new Material(
        unlit ? Rgb.BLACK : inAmbient.times(opaque),
        unlit ? Rgb.BLACK : own.times(opaque),
        model == 0 || model == 1 ? Rgb.BLACK : specular,
        shininess,
        mirrored,
        unlit ? emission.plus(own) : emission,
        through,
        refracts() ? new Medium(index, Rgb.BLACK, 0) : Medium.VACUUM);
  }

  private double opaque() {
    if (dissolve != null) {
      return dissolve;
    }
    return transparency == null ? 1 : 1 - transparency;
  }

  /** What goes through: all that is not opaque, or in models that refract all, filtered. */
  private Rgb through(double opaque) {
    double share = opaque < 1 || !refracts() ? 1 - opaque : 1;
    Rgb through = filter.times(share);
    if (model == 6) { // it reflects without Fresnel's law, and lets the rest through
      through = through.times(new Rgb(rest(specular.r()), rest(specular.g()), rest(specular.b())));
    }
    return through;
  }

  private static double rest(double share) {
    return Math.max(0, 1 - share);
  }

  /** Model 7 mirrors by Fresnel's law, as all that refracts does here; 10 is for shadows alone. */
  private boolean mirrors() {
    return model >= 3 && model <= 9 && model != 7;
  }

  private boolean refracts() {
    return model == 6 || model == 7;
  }
}
