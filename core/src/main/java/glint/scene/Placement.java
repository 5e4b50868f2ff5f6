package glint.scene;

import glint.geometry.Carried;
import glint.geometry.Surface;
import glint.math.Transform;
import glint.optics.Material;
import java.util.Objects;

/**
 * A surface at its place in the world, made of a material; immutable.
 *
 * @param materialName what its file calls the material, or ""
 * @param line where in its file it is written, from 1, or 0
 */
public record Placement(
    Surface surface, Transform toWorld, Material material, String materialName, int line) {

  /** Checks that nothing is missing. */
  public Placement {
    Objects.requireNonNull(surface, "surface");
    Objects.requireNonNull(toWorld, "toWorld");
    Objects.requireNonNull(material, "material");
    Objects.requireNonNull(materialName, "materialName");
    Carried.check(surface, toWorld);
  }

  /** Places a surface that no file names. */
  public Placement(Surface surface, Transform toWorld, Material material) {
    this(surface, toWorld, material, "", 0);
  }

  /** Places a surface where its own coordinates say. */
  public static Placement of(Surface surface, Material material) {
    return new Placement(surface, Transform.IDENTITY, material);
  }
}
