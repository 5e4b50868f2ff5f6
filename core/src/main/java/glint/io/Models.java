package glint.io;

import glint.geometry.Mesh;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The models that one scene file names, each read once, at its first use. */
final class Models {

  private final SceneFolder folder;
  private final Values values;

  /** By path; null where there is none or it has problems. */
  private final Map<String, Mesh> meshes = new HashMap<>();

  private final List<Problem> problems = new ArrayList<>();
  private final List<Problem> notes = new ArrayList<>();

  Models(SceneFolder folder, Values values) {
    this.folder = folder;
    this.values = values;
  }

  /** Returns the mesh of the model that a node names, or null with problems reported. */
  Mesh mesh(YamlNode file) {
    long before = values.problems().reports();
    String path = file == null ? "" : values.text(file);
    if (file == null || values.problems().reports() != before) {
      return null;
    }
    if (!path.toLowerCase(Locale.ROOT).endsWith(".obj")) {
      values.wrong(file, "a model's name, which ends in .obj");
      return null;
    }
    if (!meshes.containsKey(path)) {
      meshes.put(path, read(path, file));
    } else if (meshes.get(path) == null) {
      values.problems().repeat();
    }
    return meshes.get(path);
  }

  private Mesh read(String path, YamlNode file) {
    try (InputStream in = folder.open(path)) {
      ObjModel model = ObjReader.read(in, folder.name(path));
      problems.addAll(model.problems());
      notes.addAll(model.notes());
      if (model.mesh() == null) {
        values.problems().repeat();
      }
      return model.mesh();
    } catch (IOException e) {
      values.report(file, "cannot read " + SourceText.quote(path) + ": " + e.getMessage());
      return null;
    }
  }

  /** Returns what is wrong within the models, in the order of their first use. */
  List<Problem> problems() {
    return problems;
  }

  /** Returns what was left out of the models, in the order of their first use. */
  List<Problem> notes() {
    return notes;
  }
}
