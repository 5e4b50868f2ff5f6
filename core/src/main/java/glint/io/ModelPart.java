package glint.io;

import glint.optics.Material;
import java.util.Optional;

/**
 * What a part of a model is made of; immutable.
 *
 * @param name what the model calls it, or ""
 * @param material absent if no library has it
 */
record ModelPart(String name, Optional<Material> material) {}
