package glint.scene;

import glint.geometry.Carried;
import glint.geometry.Surface;
import glint.math.Transform;
import glint.optics.Material;
import java.util.Objects;

/** A surface at its place in the world, made of a material; immutable. */
public record Placement(Surface surface, Transform toWorld, Material material) {

  /** Checks that nothing is missing. */
  public Placement {
    Objects.requireNonNull(surface, "surface");
    Objects.requireNonNull(toWorld, "toWorld");
    Objects.requireNonNull(material, "material");
    Carried.check(surface, toWorld);
  }

  /** Places a surface where its own coordinates say. */
  public static Placement of(Surface surface, Material material) {
    return new Placement(surface, Transform.IDENTITY, material);
  }
}
