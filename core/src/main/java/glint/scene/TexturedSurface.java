package glint.scene;

import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.math.Transform;
import glint.optics.Material;
import glint.optics.Texture;

/** A texture on a surface: finds the place in the surface's own space. */
final class TexturedSurface {

  /**
   * Of two axes at nearly the same angle to a normal, y is left out rather than z, and z rather
   * than x. A face at 45° is off by rounding, and all of its triangles have to agree.
   */
  private static final double TIE = 1 + 0x1p-20;

  private final Texture texture;
  private final boolean mesh;
  private final double[] toWorld;
  private final double[] toObject;

  /** Returns the texture of a material on a surface at its place, or null if it has none. */
  static TexturedSurface of(Placement placement, Material material) {
    return material.texture().map(t -> new TexturedSurface(placement, t)).orElse(null);
  }

  private TexturedSurface(Placement placement, Texture texture) {
    this.texture = texture;
    mesh = placement.surface() instanceof Mesh;
    Transform transform = placement.toWorld();
    toWorld = transform.rows();
    toObject = transform.inverted().rows();
  }

  /**
   * Returns the colour at a hit.
   *
   * @param flat whether the part that was hit is flat by itself
   */
  Rgb at(Hit hit, boolean flat) {
    return texture.at(
        object(0, hit), object(4, hit), object(8, hit), flat && !mesh ? axis(hit) : Texture.SOLID);
  }

  private double object(int row, Hit hit) {
    return toObject[row] * hit.px
        + toObject[row + 1] * hit.py
        + toObject[row + 2] * hit.pz
        + toObject[row + 3];
  }

  /** Returns the axis of the surface's own space that is nearest to the normal. */
  private int axis(Hit hit) {
    double x = Math.abs(along(0, hit));
    double y = Math.abs(along(1, hit)) * TIE;
    double z = Math.abs(along(2, hit));
    if (y >= x && y >= z) {
      return 1;
    }
    return z * TIE >= x ? 2 : 0;
  }

  /** Returns a component of the normal there: the transposed matrix carries normals back. */
  private double along(int column, Hit hit) {
    return toWorld[column] * hit.nx + toWorld[4 + column] * hit.ny + toWorld[8 + column] * hit.nz;
  }
}
