package glint.io;

import glint.color.Transfer;
import glint.io.YamlNode.Entry;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.Highlight;
import glint.scene.Placement;
import glint.scene.Scene;
import glint.scene.Turntable;
import java.util.Locale;
import java.util.Optional;

/** Reads one scene of a YAML file, with the file's defaults for what it does not set. */
final class SceneReader {

  private final Values values;
  private final Fields defaults;
  private final MaterialReader materials;
  private final Models models;
  private final Images images;

  SceneReader(
      Fields defaults, MaterialReader materials, Models models, Images images, Values values) {
    this.values = values;
    this.defaults = defaults;
    this.materials = materials;
    this.models = models;
    this.images = images;
  }

  /** Returns the scene, or null with its problems reported. */
  Scene read(String name, Entry entry) {
    Fields f = new Fields(entry.value(), Section.SCENE, values);
    values.checked(
        entry.key(),
        () -> {
          Scene.checkName(name);
          return name;
        });
    Scene.Builder scene = new Scene.Builder(name);
    if (f.has("title")) {
      scene.title(title(f.get("title")));
    }
    readSettings(f, scene);
    if (ownOrDefault(f, "camera") == null) {
      f.need("camera");
    }
    scene.highlight(Highlight.valueOf(upper(f.word("highlights", "blinn", "phong"))));
    scene.transfer(Transfer.valueOf(upper(f.word("transfer", "srgb", "linear"))));
    MaterialReader own = new MaterialReader(f.get("materials"), materials, images, values);
    SurfaceReader surfaces = new SurfaceReader(own, models, values);
    if (f.has("surfaces")) {
      for (YamlNode item : values.list(f.get("surfaces"), "surfaces")) {
        Placement placement = surfaces.read(item);
        if (placement != null) {
          scene.place(placement);
        }
      }
    }
    if (f.has("expect")) {
      ExpectationReader expectations = new ExpectationReader(values);
      for (YamlNode item : values.list(f.get("expect"), "expectations")) {
        expectations.read(item, scene);
      }
    }
    if (f.has("turntable")) {
      readTurntable(f.get("turntable"), scene);
    }
    return f.build(scene::build);
  }

  private void readTurntable(YamlNode node, Scene.Builder scene) {
    Fields f = new Fields(node, Section.TURNTABLE, values);
    int frames = values.wholeNumber(f.need("frames"));
    Vector3d axis = f.has("axis") ? f.vector("axis") : new Vector3d(0, 1, 0);
    double degrees = f.number("degrees", 360);
    Optional<Vector3d> about = f.has("about") ? Optional.of(f.vector("about")) : Optional.empty();
    f.build(() -> scene.turntable(new Turntable(frames, axis, degrees, about)));
  }

  /** Reads what a scene may leave to the defaults. */
  private void readSettings(Fields f, Scene.Builder scene) {
    CameraReader cameras = new CameraReader(values);
    YamlNode image = ownOrDefault(f, "image");
    if (image != null) {
      readImage(image, scene);
    }
    YamlNode camera = ownOrDefault(f, "camera");
    if (camera != null) {
      scene.camera(cameras.camera(camera));
    }
    YamlNode background = ownOrDefault(f, "background");
    if (background != null) {
      scene.background(cameras.background(background));
    }
    YamlNode lights = ownOrDefault(f, "lights");
    if (lights != null) {
      LightReader reader = new LightReader(values);
      for (YamlNode item : values.list(lights, "lights")) {
        Light light = reader.read(item);
        if (light != null) {
          scene.light(light);
        }
      }
    }
  }

  /** Reads the defaults as a scene would, so that they are checked even if none uses them. */
  void checkDefaults() {
    readSettings(defaults, new Scene.Builder("defaults"));
  }

  private YamlNode ownOrDefault(Fields f, String key) {
    return f.has(key) || defaults == null ? f.get(key) : defaults.get(key);
  }

  private void readImage(YamlNode node, Scene.Builder scene) {
    Fields f = new Fields(node, Section.IMAGE, values);
    int width = values.wholeNumber(f.need("width"));
    int height = values.wholeNumber(f.need("height"));
    f.build(
        () -> {
          Scene.checkSize(width, height);
          return scene.size(width, height);
        });
  }

  private String title(YamlNode node) {
    String title = values.text(node);
    for (int i = 0; i < title.length(); i++) {
      if (Character.isISOControl(title.charAt(i))) {
        values.report(node, "a title is one line of text");
        return "";
      }
    }
    return title;
  }

  private static String upper(String word) {
    return word.toUpperCase(Locale.ROOT);
  }
}
