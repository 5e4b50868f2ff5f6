package glint.io;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * The kinds of maps in a YAML scene file and the keys that each may hold.
 *
 * <p>The schema beside the scenes says the same; a test holds the two against each other.
 */
enum Section {
  FILE("a scene file", "scenes materials defaults", ""),
  DEFAULTS("defaults", "image camera background lights", ""),
  SCENE(
      "a scene",
      "title image camera background lights surfaces materials highlights transfer expect"
          + " turntable",
      ""),
  TURNTABLE("a turntable", "frames axis degrees about", ""),
  EXPECTATION("an expectation", "pixel value mean tolerance relative samples depth", ""),
  IMAGE("an image", "width height", ""),
  CAMERA("a camera", "position look_at up fov orthographic near far lens", ""),
  LENS("a lens", "radius focus", ""),
  FOV("an angle of view", "vertical horizontal aspect", ""),
  BACKGROUND("a background", "down up", ""),
  LIGHT("a light", "ambient point directional spot sphere rectangle", "environment"),
  AMBIENT("an ambient light", "color", ""),
  POINT("a point light", "position color falloff", ""),
  DIRECTIONAL("a directional light", "direction color", ""),
  SPOT("a spot light", "position look_at color angle softness", ""),
  LAMP("a sphere that shines", "center radius color", ""),
  RECTANGLE("a rectangle that shines", "corner edge1 edge2 color", ""),
  SURFACE("a surface", "sphere triangle plane quad box pyramid cylinder cone mesh", "prism"),
  SPHERE("a sphere", "center radius" + Section.PLACED, ""),
  TRIANGLE("a triangle", "vertices" + Section.PLACED, ""),
  PLANE("a plane", "point normal" + Section.PLACED, ""),
  QUAD("a quad", "corner edge1 edge2" + Section.PLACED, ""),
  BOX("a box", "min max" + Section.PLACED, ""),
  PYRAMID("a pyramid", "apex base" + Section.PLACED, ""),
  CYLINDER("a cylinder", "base top radius top_radius capped" + Section.PLACED, ""),
  CONE("a cone", "base top radius top_radius capped" + Section.PLACED, ""),
  MESH("a mesh", "file smooth" + Section.PLACED, ""),
  STEP("a transform", "scale rotate translate matrix", ""),
  ROTATION("a rotation", "axis degrees euler look up", ""),
  MATERIAL(
      "a material",
      "color ambient diffuse specular shininess reflection gloss emission"
          + " transparency ior absorption priority texture",
      ""),
  TEXTURE("a texture", "checker stripes image mapping scale offset wrap", "wood"),
  MAPPING("a mapping", "planar spherical", ""),
  PLANAR("a planar mapping", "corner edge1 edge2", ""),
  SPHERICAL("a spherical mapping", "center up front", ""),
  CHECKER("a checker", "size colors", ""),
  STRIPES("a pattern of stripes", "size colors", "");

  private static final String PLACED = " material scale rotate translate transform motion";

  private final String title;
  private final List<String> keys;
  private final List<String> later;

  Section(String title, String keys, String later) {
    this.title = title;
    this.keys = List.of(keys.split(" "));
    this.later = later.isEmpty() ? Collections.emptyList() : Arrays.asList(later.split(" "));
  }

  /** Returns what a message calls such a map: "a sphere". */
  String title() {
    return title;
  }

  /** Returns the title without its article. */
  String noun() {
    return title.substring(title.indexOf(' ') + 1);
  }

  /** Returns whether the one key of such a map says what kind of thing its value is. */
  boolean namesKinds() {
    return this == LIGHT || this == SURFACE || this == STEP;
  }

  /** Returns what a message says that such a map holds: "a fov {vertical, horizontal}". */
  String form() {
    return title + " {" + String.join(", ", keys) + "}";
  }

  /** Returns the keys that this version reads. */
  List<String> keys() {
    return keys;
  }

  /** Returns the keys of the format that this version knows, but cannot render yet. */
  List<String> later() {
    return later;
  }
}
