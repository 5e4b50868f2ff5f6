package glint.io;

import glint.color.Rgb;
import glint.io.YamlNode.Entry;
import glint.io.YamlNode.Scalar;
import glint.light.Light;
import glint.math.Vector3d;

/** Reads lights. */
final class LightReader {

  private final Values values;

  LightReader(Values values) {
    this.values = values;
  }

  /** Returns the light of one list item, or null with its problems reported. */
  Light read(YamlNode item) {
    Entry entry = Fields.kind(item, Section.LIGHT, values);
    if (entry == null) {
      return null;
    }
    YamlNode node = entry.value();
    return switch (((Scalar) entry.key()).text()) {
      case "ambient" -> ambient(new Fields(node, Section.AMBIENT, values));
      case "point" -> point(new Fields(node, Section.POINT, values));
      case "directional" -> directional(new Fields(node, Section.DIRECTIONAL, values));
      case "sphere" -> sphere(new Fields(node, Section.LAMP, values));
      case "rectangle" -> rectangle(new Fields(node, Section.RECTANGLE, values));
      default -> spot(new Fields(node, Section.SPOT, values));
    };
  }

  private static Light ambient(Fields f) {
    Rgb color = f.light("color");
    return f.build(() -> new Light.Ambient(color));
  }

  private static Light point(Fields f) {
    Vector3d position = f.vector("position");
    Rgb color = f.light("color");
    boolean falloff = f.word("falloff", "none", "inverse-square").equals("inverse-square");
    return f.build(() -> new Light.Point(position, color, falloff));
  }

  private static Light directional(Fields f) {
    Vector3d direction = f.vector("direction");
    Rgb color = f.light("color");
    return f.build(() -> new Light.Directional(direction, color));
  }

  private static Light sphere(Fields f) {
    Vector3d center = f.vector("center");
    double radius = f.number("radius");
    Rgb color = f.light("color");
    return f.build(() -> new Light.Sphere(center, radius, color));
  }

  private static Light rectangle(Fields f) {
    Vector3d corner = f.vector("corner");
    Vector3d edge1 = f.vector("edge1");
    Vector3d edge2 = f.vector("edge2");
    Rgb color = f.light("color");
    return f.build(() -> new Light.Rectangle(corner, edge1, edge2, color));
  }

  private static Light spot(Fields f) {
    Vector3d position = f.vector("position");
    Vector3d lookAt = f.vector("look_at");
    Rgb color = f.light("color");
    double angle = f.number("angle");
    double softness = f.number("softness", 0);
    return f.build(() -> new Light.Spot(position, lookAt, color, angle, softness));
  }
}
