package glint.optics;

/** Finds where on an image a point of a surface's own space lies; immutable. */
public sealed interface Mapping permits Planar, Spherical, Around, Faces, Flat {

  /**
   * Sets u and v of a texel: 0 to 1 is the image once.
   *
   * @param flat of a flat part the axis nearest to its normal, 0 to 2; else {@link Pattern#SOLID}
   */
  void find(double x, double y, double z, int flat, Texel texel);
}
