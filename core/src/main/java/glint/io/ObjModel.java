package glint.io;

import glint.geometry.Mesh;
import java.util.List;

/**
 * What was read from one OBJ file; immutable.
 *
 * @param mesh the triangles, or null if there are problems
 * @param materials what the file calls the material of each part of the mesh; "" for none
 * @param libraries what follows each {@code mtllib}, the same only once
 * @param problems what is wrong, in file order
 * @param notes what was left out or assumed, in file order
 */
public record ObjModel(
    Mesh mesh,
    List<ObjName> materials,
    List<ObjName> libraries,
    List<Problem> problems,
    List<Problem> notes) {

  /** Copies the lists. */
  public ObjModel {
    materials = List.copyOf(materials);
    libraries = List.copyOf(libraries);
    problems = List.copyOf(problems);
    notes = List.copyOf(notes);
  }
}
