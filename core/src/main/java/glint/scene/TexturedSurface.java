package glint.scene;

import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Primitives;
import glint.geometry.Surface;
import glint.math.Transform;
import glint.optics.ImageTexture;
import glint.optics.Mapping;
import glint.optics.Pattern;
import glint.optics.Texel;
import glint.optics.Texture;

/**
 * A texture on a surface, wherever that stands: finds the place in the surface's own space, or on
 * its mesh.
 */
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

  TexturedSurface(Surface surface, Texture texture) {
    mesh = surface instanceof Mesh m ? m : null;
    pattern = texture instanceof Pattern p ? p : null;
    image = texture instanceof ImageTexture i ? i : null;
    mapping = image == null ? null : image.mapping().orElseGet(() -> OwnMapping.of(surface));
  }

  /** Returns the image, or null if the texture is none. */
  ImageTexture image() {
    return image;
  }

  /** Sets a texel to what is seen at a hit. */
  void at(Hit hit, Primitives primitives, Transform toWorld, Texel texel) {
    if (pattern == null && mapping == null) {
      mesh.findTexture(primitives.triangle(hit), hit);
      texel.u = hit.textureU;
      texel.v = hit.textureV;
      image.at(texel);
      return;
    }
    double[] m = texel.numbers;
    toWorld.copyTo(m);
    double x = object(m, 0, hit);
    double y = object(m, 3, hit);
    double z = object(m, 6, hit);
    int flat = mesh == null && primitives.isFlat(hit) ? axis(m, hit) : Pattern.SOLID;
    if (pattern != null) {
      texel.set(pattern.at(x, y, z, flat), pattern.cell(x, y, z, flat));
    } else {
      mapping.find(x, y, z, flat, texel);
      image.at(texel);
    }
  }

  /** Returns a coordinate in the surface's own space, by a row of M⁻¹, of the point less T. */
  private static double object(double[] m, int row, Hit hit) {
    return m[row] * (hit.px - hit.movedX - m[18])
        + m[row + 1] * (hit.py - hit.movedY - m[19])
        + m[row + 2] * (hit.pz - hit.movedZ - m[20]);
  }

  /** Returns the axis of the surface's own space that is nearest to the normal. */
  private static int axis(double[] m, Hit hit) {
    double x = Math.abs(along(m, 9, hit));
    double y = Math.abs(along(m, 10, hit)) * TIE;
    double z = Math.abs(along(m, 11, hit));
    if (y >= x && y >= z) {
      return 1;
    }
    return z * TIE >= x ? 2 : 0;
  }

  /** Returns a component of the normal there: the transposed matrix carries normals back. */
  private static double along(double[] m, int column, Hit hit) {
    return m[column] * hit.nx + m[column + 3] * hit.ny + m[column + 6] * hit.nz;
  }
}
