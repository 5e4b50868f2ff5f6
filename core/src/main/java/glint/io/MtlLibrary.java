package glint.io;

import java.util.List;
import java.util.Map;

/**
 * What was read from one MTL file; immutable.
 *
 * @param materials by name
 * @param problems what is wrong, in file order
 * @param notes what was left out or assumed, in file order
 */
public record MtlLibrary(
    Map<String, MtlMaterial> materials, List<Problem> problems, List<Problem> notes) {

  /** Copies map and lists. */
  public MtlLibrary {
    materials = Map.copyOf(materials);
    problems = List.copyOf(problems);
    notes = List.copyOf(notes);
  }
}
