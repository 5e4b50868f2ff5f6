package glint.io;

import glint.io.YamlNode.Entry;
import glint.io.YamlNode.Mapping;
import glint.io.YamlNode.Sequence;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Reads YAML scene files: any number of scenes and what they share (docs/scene-format.md). */
final class SceneFileReader {

  private final Problems problems;
  private final Problems notes;
  private final Values values;
  private final Images images;
  private final Models models;
  private final List<Scene> scenes = new ArrayList<>();
  private final List<String> broken = new ArrayList<>();

  SceneFileReader(SceneFolder folder, String fileName, Problems problems) {
    this.problems = problems;
    notes = new Problems(fileName);
    values = new Values(problems, notes);
    images = new Images(folder);
    models = new Models(folder, images, values);
  }

  SceneFile read(String text) {
    YamlNode root = YamlComposer.compose(text, problems);
    if (root != null) {
      readFile(root);
    }
    List<Problem> all = new ArrayList<>(problems.inFileOrder());
    all.addAll(models.problems());
    List<Problem> remarks = new ArrayList<>(notes.inFileOrder());
    remarks.addAll(models.notes());
    return new SceneFile(scenes, broken, all, remarks);
  }

  private void readFile(YamlNode root) {
    Fields file = new Fields(root, Section.FILE, values);
    MaterialReader materials = new MaterialReader(file.get("materials"), null, images, values);
    Fields defaults =
        file.has("defaults") ? new Fields(file.get("defaults"), Section.DEFAULTS, values) : null;
    SceneReader reader = new SceneReader(defaults, materials, models, images, values);
    if (defaults != null) {
      reader.checkDefaults();
    }
    YamlNode node = file.need("scenes");
    if (node == null) {
      return;
    }
    if (!(node instanceof Mapping map) || map.entries().isEmpty()) {
      values.wrong(node, "a map from names to scenes");
      return;
    }
    boolean lit = defaults != null && defaults.get("lights") instanceof Sequence;
    long defaultLights = lit ? ((Sequence) defaults.get("lights")).items().size() : 0;
    if (defaultLights * map.entries().size() > YamlComposer.MOST_NODES) {
      values.report(node, "too large: so many scenes cannot share so many default lights");
      return;
    }
    Keyed keyed = Keyed.of(map, values);
    for (Map.Entry<String, Entry> each : keyed.first().entrySet()) {
      Scene scene = reader.read(each.getKey(), each.getValue());
      if (scene != null && !keyed.repeated().contains(each.getKey())) {
        scenes.add(scene);
      } else {
        broken.add(each.getKey());
      }
    }
  }
}
