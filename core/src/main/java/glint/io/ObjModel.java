package glint.io;

import glint.geometry.Mesh;
import java.util.List;

/**
 * What was read from one OBJ file; immutable.
 *
 * @param mesh the triangles, or null if there are problems
 * @param problems what is wrong, in file order
 * @param notes what was left out or assumed, in file order
 */
public record ObjModel(Mesh mesh, List<Problem> problems, List<Problem> notes) {

  /** Copies the lists. */
  public ObjModel {
    problems = List.copyOf(problems);
    notes = List.copyOf(notes);
  }
}
