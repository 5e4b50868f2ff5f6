package glint.scene;

import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Primitives;
import glint.math.Transform;
import glint.optics.ImageTexture;
import glint.optics.Mapping;
import glint.optics.Material;
import glint.optics.Pattern;
import glint.optics.Texel;
import glint.optics.Texture;

/** A texture on a surface: finds the place in the surface's own space, or on its mesh. */
final class TexturedSurface {

  /**
   * Of two axes at nearly the same angle to a normal, y is left out rather than z, and z rather
   * than x. A face at 45° is off by rounding, and all of its triangles have to agree.
   */
  private static final double TIE = 1 + 0x1p-20;

  /** The one or the other. */
  private final Pattern pattern;

  private final ImageTexture image;

  /** How the image lies, or null where the points of a mesh say so. */
  private final Mapping mapping;

  /** The mesh that this is a part of, or null. */
  private final Mesh mesh;

  /** Null where no place in the surface's own space is asked for. */
  private final double[] toWorld;

  private final double[] toObject;

  /** Returns the texture of a material on a surface at its place, or null if it has none. */
  static TexturedSurface of(Placement placement, Material material) {
    return material.texture().map(t -> new TexturedSurface(placement, t)).orElse(null);
  }

  private TexturedSurface(Placement placement, Texture texture) {
    mesh = placement.surface() instanceof Mesh m ? m : null;
    pattern = texture instanceof Pattern p ? p : null;
    image = texture instanceof ImageTexture i ? i : null;
    mapping =
        image == null ? null : image.mapping().orElseGet(() -> OwnMapping.of(placement.surface()));
    boolean placed = pattern != null || mapping != null;
    Transform transform = placement.toWorld();
    toWorld = placed ? transform.rows() : null;
    toObject = placed ? transform.inverted().rows() : null;
  }

  /** Sets a texel to what is seen at a hit. */
  void at(Hit hit, Primitives primitives, Texel texel) {
    if (toObject == null) {
      mesh.findTexture(primitives.triangle(hit), hit);
      texel.u = hit.textureU;
      texel.v = hit.textureV;
      image.at(texel);
      return;
    }
    double x = object(0, hit);
    double y = object(4, hit);
    double z = object(8, hit);
    int flat = mesh == null && primitives.isFlat(hit) ? axis(hit) : Pattern.SOLID;
    if (pattern != null) {
      texel.set(pattern.at(x, y, z, flat));
    } else {
      mapping.find(x, y, z, flat, texel);
      image.at(texel);
    }
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
