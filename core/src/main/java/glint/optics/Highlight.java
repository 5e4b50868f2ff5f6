package glint.optics;

/** Which angle a highlight is measured by. */
public enum Highlight {
  /** Blinn (1977): (n·h)^shininess, h half way between light and viewer. */
  BLINN,
  /** Phong (1975): (r·v)^shininess, r the mirrored light direction. */
  PHONG
}
