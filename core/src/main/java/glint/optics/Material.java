package glint.optics;

import glint.color.Rgb;
import glint.math.Check;
import java.util.Optional;

/**
 * How a surface answers light, after Whitted (1980) with Blinn's or Phong's highlight; immutable.
 *
 * <p>All factors are linear RGB, zero or more, and are not forced to conserve energy.
 *
 * @param ambient the share of the ambient light that the surface gives back, colour included
 * @param diffuse the Lambertian share of a light's colour times n·l, colour included
 * @param specular the strength of the highlight
 * @param shininess the highlight's exponent, zero or more
 * @param reflection the share of the mirror ray's light that is added
 * @param emission light that the surface gives by itself
 * @param transparency the share of the light that goes through or is reflected by Fresnel's law
 * @param interior what the surface encloses; matters where transparency is not black
 * @param texture what multiplies ambient and diffuse, from place to place
 * @param gloss the exponent of the lobe that mirrored light is spread over, zero or more; infinite
 *     for a mirror
 */
public record Material(
    Rgb ambient,
    Rgb diffuse,
    Rgb specular,
    double shininess,
    Rgb reflection,
    Rgb emission,
    Rgb transparency,
    Medium interior,
    Optional<Texture> texture,
    double gloss) {

  /** Plain white diffuse, what a surface without a material is made of. */
  public static final Material WHITE =
      new Material(Rgb.WHITE, Rgb.WHITE, Rgb.BLACK, 32, Rgb.BLACK, Rgb.BLACK);

  /** Checks that every factor is finite and not negative. */
  public Material {
    ambient.requireLight("ambient");
    diffuse.requireLight("diffuse");
    specular.requireLight("specular");
    reflection.requireLight("reflection");
    emission.requireLight("emission");
    transparency.requireLight("transparency");
    Check.range("shininess", shininess, 0, 1e9);
    if (gloss != Double.POSITIVE_INFINITY) {
      Check.range("gloss", gloss, 0, 1e9);
    }
  }

  /** Makes a material of the same colour everywhere. */
  public Material(
      Rgb ambient,
      Rgb diffuse,
      Rgb specular,
      double shininess,
      Rgb reflection,
      Rgb emission,
      Rgb transparency,
      Medium interior) {
    this(
        ambient,
        diffuse,
        specular,
        shininess,
        reflection,
        emission,
        transparency,
        interior,
        Optional.empty(),
        Double.POSITIVE_INFINITY);
  }

  /** Makes an opaque material of the same colour everywhere. */
  public Material(
      Rgb ambient, Rgb diffuse, Rgb specular, double shininess, Rgb reflection, Rgb emission) {
    this(ambient, diffuse, specular, shininess, reflection, emission, Rgb.BLACK, Medium.VACUUM);
  }

  /** Returns the same material under a texture. */
  public Material textured(Texture pattern) {
    return new Material(
        ambient,
        diffuse,
        specular,
        shininess,
        reflection,
        emission,
        transparency,
        interior,
        Optional.of(pattern),
        gloss);
  }

  /** Returns the same material, spreading what it mirrors over a lobe of this exponent. */
  public Material glossy(double exponent) {
    return new Material(
        ambient,
        diffuse,
        specular,
        shininess,
        reflection,
        emission,
        transparency,
        interior,
        texture,
        exponent);
  }

  /** Returns whether mirrored light is spread. */
  public boolean isGlossy() {
    return gloss < Double.POSITIVE_INFINITY;
  }

  /** Returns whether light goes through. */
  public boolean isTransparent() {
    return !transparency.isBlack();
  }
}
