package glint.io;

import glint.io.YamlNode.Mapping;
import glint.math.Check;
import glint.math.Vector3d;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Lens;
import glint.scene.Orthographic;
import glint.scene.Perspective;
import glint.scene.Projection;
import java.util.Optional;

/** Reads cameras and what they see where nothing is. */
final class CameraReader {

  private final Values values;

  CameraReader(Values values) {
    this.values = values;
  }

  Camera camera(YamlNode node) {
    Fields f = new Fields(node, Section.CAMERA, values);
    Vector3d position = f.vector("position");
    Vector3d lookAt = f.vector("look_at");
    Vector3d up = f.has("up") ? f.vector("up") : new Vector3d(0, 1, 0);
    Projection projection = projection(f);
    double near = f.number("near", 0);
    double far = f.number("far", Double.POSITIVE_INFINITY);
    Optional<Lens> lens = lens(f, position, lookAt);
    return f.build(() -> new Camera(position, lookAt, up, projection, near, far, lens));
  }

  private Optional<Lens> lens(Fields camera, Vector3d position, Vector3d lookAt) {
    if (!camera.has("lens")) {
      return Optional.empty();
    }
    Fields f = new Fields(camera.get("lens"), Section.LENS, values);
    double radius = f.number("radius");
    double focus = f.has("focus") ? f.number("focus") : lookAt.minus(position).length();
    return Optional.ofNullable(f.build(() -> new Lens(radius, focus)));
  }

  private Projection projection(Fields camera) {
    if (!camera.means("orthographic")) {
      return perspective(camera.need("fov"));
    }
    if (camera.has("fov")) {
      values.report(camera.get("orthographic"), "a camera has either 'fov' or 'orthographic'");
    }
    return camera.has("orthographic")
        ? values.checkedNumber(camera.get("orthographic"), Orthographic::new)
        : null;
  }

  private Projection perspective(YamlNode node) {
    if (node == null) {
      return null;
    }
    if (!(node instanceof Mapping)) {
      return values.checkedNumber(node, Projection::vertical);
    }
    Fields f = new Fields(node, Section.FOV, values);
    if (f.isSound() && f.has("vertical") == f.has("horizontal")) {
      values.report(node, "an angle of view is either 'vertical' or 'horizontal'");
    }
    boolean horizontal = f.has("horizontal");
    String key = horizontal ? "horizontal" : "vertical";
    double degrees = f.number(key, 1);
    Double aspect = f.has("aspect") ? aspect(f.get("aspect")) : Double.valueOf(0);
    YamlNode number = f.has(key) ? f.get(key) : node;
    return f.isSound() && aspect != null
        ? values.checked(number, () -> new Perspective(degrees, horizontal, aspect))
        : null;
  }

  private Double aspect(YamlNode node) {
    return values.checkedNumber(
        node,
        v -> {
          Check.positive("aspect", v);
          return v;
        });
  }

  Background background(YamlNode node) {
    if (!(node instanceof Mapping)) {
      return Background.constant(values.light("background", node));
    }
    Fields f = new Fields(node, Section.BACKGROUND, values);
    return new Background(f.light("down"), f.light("up"));
  }
}
