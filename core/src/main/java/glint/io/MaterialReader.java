package glint.io;

import glint.color.Rgb;
import glint.io.YamlNode.Entry;
import glint.io.YamlNode.Mapping;
import glint.io.YamlNode.Scalar;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Texture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/** The materials that a file or a scene defines by name, read once each. */
final class MaterialReader {

  private static final String DEFAULT = "default";

  private static final int MOST_NAMES = 1000;

  private final Values values;
  private final Images images;
  private final MaterialReader outer;

  /** By name; null where the definition has a problem. */
  private final Map<String, Material> named = new HashMap<>();

  /**
   * Reads all definitions.
   *
   * @param outer the materials of the file, for those of a scene; else null
   * @param definitions the map of them, or null if there is none
   */
  MaterialReader(YamlNode definitions, MaterialReader outer, Images images, Values values) {
    this.values = values;
    this.images = images;
    this.outer = outer;
    if (definitions == null) {
      return;
    }
    if (!(definitions instanceof Mapping map)) {
      values.wrong(definitions, "a map from names to materials");
      return;
    }
    Keyed keyed = Keyed.of(map, values);
    for (Map.Entry<String, Entry> each : keyed.first().entrySet()) {
      Material material = read(each.getValue().value());
      named.put(each.getKey(), keyed.repeated().contains(each.getKey()) ? null : material);
    }
  }

  /** Returns the material of a surface, or null with problems reported. */
  Material of(Fields surface) {
    YamlNode node = surface.get("material");
    if (node == null) {
      MaterialReader definer = definer(DEFAULT);
      return definer == null ? Material.WHITE : definer.recall(DEFAULT);
    }
    if (node instanceof Mapping) {
      return read(node);
    }
    if (!(node instanceof Scalar scalar && scalar.isText())) {
      values.wrong(node, "a material's name or " + Section.MATERIAL.form());
      return null;
    }
    MaterialReader definer = definer(scalar.text());
    if (definer == null) {
      values.report(
          node,
          "material "
              + SourceText.quote(scalar.text())
              + " is not defined in this scene or file"
              + Suggestion.hintOrList(scalar.text(), names()));
      return null;
    }
    return definer.recall(scalar.text());
  }

  private MaterialReader definer(String name) {
    if (named.containsKey(name)) {
      return this;
    }
    return outer == null ? null : outer.definer(name);
  }

  /** Returns a material; one with a problem makes the scene that uses it unsound, too. */
  private Material recall(String name) {
    Material material = named.get(name);
    if (material == null) {
      values.problems().repeat();
    }
    return material;
  }

  /** Returns what a suggestion may be taken from: nothing if that would take long. */
  private List<String> names() {
    int count = named.size() + (outer == null ? 0 : outer.named.size());
    List<String> names = new ArrayList<>();
    if (count <= MOST_NAMES) {
      names.addAll(named.keySet());
      names.addAll(outer == null ? List.of() : outer.names());
      names.sort(null);
    }
    return names;
  }

  private Material read(YamlNode node) {
    Fields f = new Fields(node, Section.MATERIAL, values);
    boolean otherwiseLit = f.has("reflection") || f.has("emission") || f.has("transparency");
    Rgb color = f.light("color", Rgb.WHITE);
    Rgb diffuse = f.light("diffuse", otherwiseLit ? Rgb.BLACK : Rgb.WHITE);
    Rgb ambient = f.light("ambient", diffuse);
    Rgb specular = f.light("specular", Rgb.BLACK);
    double shininess = f.number("shininess", 32);
    Rgb reflection = f.light("reflection", Rgb.BLACK);
    double gloss = f.number("gloss", Double.POSITIVE_INFINITY);
    Rgb emission = f.light("emission", Rgb.BLACK);
    Rgb transparency = f.light("transparency", Rgb.BLACK);
    if (!f.has("transparency")) {
      f.noteIdle("has no effect without 'transparency'", "ior", "absorption", "priority");
    }
    if (!f.has("reflection") && !f.has("transparency")) {
      f.noteIdle("has no effect where nothing is mirrored", "gloss");
    }
    if (diffuse.isBlack() && ambient.isBlack()) {
      f.noteIdle("has no effect where 'diffuse' and 'ambient' are 0", "texture");
    }
    Texture texture =
        f.has("texture") ? new TextureReader(values, images).read(f.get("texture")) : null;
    Supplier<Medium> interior = interior(f);
    return f.build(
        () ->
            new Material(
                color.times(ambient),
                color.times(diffuse),
                specular,
                shininess,
                reflection,
                emission,
                transparency,
                interior.get(),
                Optional.ofNullable(texture),
                gloss));
  }

  /** Returns what makes the medium inside; it checks the values. */
  private static Supplier<Medium> interior(Fields f) {
    if (!f.has("ior") && !f.has("absorption") && !f.has("priority")) {
      return () -> Medium.VACUUM;
    }
    double ior = f.number("ior", 1);
    Rgb absorption = f.coefficients("absorption", Rgb.BLACK);
    int priority = f.wholeNumber("priority", 0);
    return () -> new Medium(ior, absorption, priority);
  }
}
