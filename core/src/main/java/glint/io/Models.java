package glint.io;

import glint.geometry.Mesh;
import glint.math.Check;
import glint.optics.Material;
import glint.scene.NamedMaterial;
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
  private final Images images;
  private final Values values;

  /** By path; null where there is none or it has problems. */
  private final Map<String, ObjModel> read = new HashMap<>();

  /** By path, for models whose own materials were asked for; null where these have problems. */
  private final Map<String, List<ModelPart>> parts = new HashMap<>();

  /** What was asked to be smooth, by path and degrees. */
  private final Map<Smoothed, Mesh> smoothed = new HashMap<>();

  private final List<Problem> problems = new ArrayList<>();
  private final List<Problem> notes = new ArrayList<>();

  private record Smoothed(String path, double degrees) {}

  Models(SceneFolder folder, Images images, Values values) {
    this.folder = folder;
    this.images = images;
    this.values = values;
  }

  /**
   * Returns the mesh of the model that a node names, or null with problems reported.
   *
   * @param smooth the angle in degrees below which its faces share normals, or null
   */
  Mesh mesh(YamlNode file, YamlNode smooth) {
    Double degrees = smooth == null ? null : values.checkedNumber(smooth, Models::angle);
    Mesh mesh = mesh(file);
    if (degrees == null || mesh == null) {
      return mesh;
    }
    Smoothed key = new Smoothed(values.text(file), degrees);
    return smoothed.computeIfAbsent(key, any -> mesh.smoothed(degrees));
  }

  private static double angle(double degrees) {
    Check.range("smooth", degrees, 0, 180);
    return degrees;
  }

  private Mesh mesh(YamlNode file) {
    long before = values.problems().reports();
    String path = file == null ? "" : values.text(file);
    if (file == null || values.problems().reports() != before) {
      return null;
    }
    if (!path.toLowerCase(Locale.ROOT).endsWith(".obj")) {
      values.wrong(file, "a model's name, which ends in .obj");
      return null;
    }
    if (!read.containsKey(path)) {
      read.put(path, read(path, file));
    } else if (read.get(path) == null) {
      values.problems().repeat();
    }
    return read.get(path) == null ? null : read.get(path).mesh();
  }

  /**
   * Returns the materials of a model, one for each part of its mesh, or null with problems
   * reported.
   *
   * @param file names a model whose mesh could be read
   * @param standard for parts that have none
   */
  List<NamedMaterial> materials(YamlNode file, Material standard) {
    String path = values.text(file);
    if (!parts.containsKey(path)) {
      parts.put(path, readParts(path));
    }
    if (parts.get(path) == null) {
      values.problems().repeat();
      return null;
    }
    List<NamedMaterial> materials = new ArrayList<>();
    for (ModelPart part : parts.get(path)) {
      Material own = part.material().orElse(standard);
      materials.add(new NamedMaterial(part.name(), own));
    }
    return materials;
  }

  private ObjModel read(String path, YamlNode file) {
    try (InputStream in = folder.open(path)) {
      ObjModel model = ObjReader.read(in, folder.name(path));
      problems.addAll(model.problems());
      notes.addAll(model.notes());
      if (model.mesh() == null) {
        values.problems().repeat();
        return null;
      }
      return model;
    } catch (IOException e) {
      values.report(file, "cannot read " + SourceText.quote(path) + ": " + e.getMessage());
      return null;
    }
  }

  private List<ModelPart> readParts(String path) {
    ModelMaterials materials = new ModelMaterials(read.get(path), path, folder, images);
    problems.addAll(materials.problems());
    notes.addAll(materials.notes());
    return materials.problems().isEmpty() ? materials.parts() : null;
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
