package glint.scene;

import glint.optics.Material;
import java.util.Objects;

/**
 * A material and what its file calls it; immutable.
 *
 * @param name as written, or ""
 */
public record NamedMaterial(String name, Material material) {

  /** Checks that nothing is missing. */
  public NamedMaterial {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(material, "material");
  }
}
