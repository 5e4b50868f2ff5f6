package glint.io;

import glint.optics.Material;
import java.util.Optional;

/**
 * A material of an MTL file; immutable.
 *
 * @param map the image that multiplies its diffuse colour
 */
public record MtlMaterial(Material material, Optional<MtlMap> map) {}
