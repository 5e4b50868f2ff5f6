package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.geometry.Mesh;
import glint.geometry.MeshFacts;
import glint.math.Vector3d;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Reads models from texts, for tests. */
final class ObjText {

  private ObjText() {}

  static ObjModel read(byte[] bytes) {
    try {
      return ObjReader.read(new ByteArrayInputStream(bytes), "m.obj");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static ObjModel read(String text) {
    return read(text.getBytes(StandardCharsets.UTF_8));
  }

  /** Returns the mesh of a model without problems. */
  static Mesh mesh(byte[] bytes) {
    ObjModel model = read(bytes);
    assertEquals(List.of(), model.problems());
    return model.mesh();
  }

  static Mesh mesh(String text) {
    return mesh(text.getBytes(StandardCharsets.UTF_8));
  }

  /** Returns the corners of all triangles. */
  static List<Vector3d> corners(Mesh mesh) {
    List<Vector3d> corners = new ArrayList<>();
    for (int i = 0; i < mesh.triangles(); i++) {
      corners.addAll(MeshFacts.corners(mesh, i));
    }
    return corners;
  }

  static List<Vector3d> corners(String text) {
    return corners(mesh(text));
  }

  /** Returns the problems of a text that is wrong, without the file's name. */
  static List<String> problems(String text) {
    ObjModel model = read(text);
    assertEquals(null, model.mesh());
    return lines(model.problems());
  }

  /** Returns the notes of a text that is not, without the file's name. */
  static List<String> notes(String text) {
    ObjModel model = read(text);
    assertEquals(List.of(), model.problems());
    return lines(model.notes());
  }

  private static List<String> lines(List<Problem> problems) {
    return problems.stream()
        .map(p -> p.toString().substring("m.obj:".length()))
        .collect(Collectors.toList());
  }
}
