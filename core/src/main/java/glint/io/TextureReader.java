package glint.io;

import glint.color.Rgb;
import glint.image.ByteImage;
import glint.io.YamlNode.Sequence;
import glint.math.Vector3d;
import glint.optics.Checker;
import glint.optics.ImageTexture;
import glint.optics.Layout;
import glint.optics.Mapping;
import glint.optics.Planar;
import glint.optics.Spherical;
import glint.optics.Stripes;
import glint.optics.Texture;
import glint.optics.Wrap;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Reads textures. */
final class TextureReader {

  private static final List<String> KINDS = List.of("checker", "stripes", "image");
  private static final List<String> OF_IMAGES = List.of("mapping", "scale", "offset", "wrap");

  private final Values values;
  private final Images images;

  TextureReader(Values values, Images images) {
    this.values = values;
    this.images = images;
  }

  /** Makes a pattern of a size and two colours. */
  private interface Pattern {
    Texture of(double size, Rgb a, Rgb b);
  }

  /** Returns the texture, or null with its problems reported. */
  Texture read(YamlNode node) {
    Fields f = new Fields(node, Section.TEXTURE, values);
    if (f.isSound() && KINDS.stream().filter(f::has).count() != 1) {
      values.report(node, "a texture is either a 'checker', 'stripes' or an 'image'");
    }
    if (f.isSound() && !f.has("image")) {
      for (String key : OF_IMAGES) {
        if (f.has(key)) {
          values.report(f.get(key), "'" + key + "' belongs to an 'image'");
        }
      }
    }
    if (!f.isSound()) {
      return null;
    }
    if (f.has("image")) {
      return image(f);
    }
    return f.has("checker")
        ? pattern(new Fields(f.get("checker"), Section.CHECKER, values), Checker::new)
        : pattern(new Fields(f.get("stripes"), Section.STRIPES, values), Stripes::new);
  }

  private Texture pattern(Fields f, Pattern kind) {
    double size = f.number("size");
    YamlNode colors = f.need("colors");
    if (!(colors instanceof Sequence list && list.items().size() == 2)) {
      if (colors != null) {
        values.wrong(colors, "2 colours [a, b]");
      }
      return null;
    }
    List<YamlNode> both = list.items();
    Rgb a = values.light("colors", both.get(0));
    Rgb b = values.light("colors", both.get(1));
    return f.build(() -> kind.of(size, a, b));
  }

  private Texture image(Fields f) {
    String file = values.text(f.get("image"));
    Mapping mapping = f.has("mapping") ? mapping(f.get("mapping")) : null;
    List<Double> scale = scale(f);
    List<Double> offset = f.has("offset") ? values.numbers(f.get("offset"), 2, "[u, v]") : PAIR;
    Wrap wrap = Wrap.valueOf(f.word("wrap", "repeat", "clamp", "mirror").toUpperCase(Locale.ROOT));
    Layout layout =
        f.build(() -> new Layout(scale.get(0), scale.get(1), offset.get(0), offset.get(1), wrap));
    if (layout == null) {
      return null;
    }
    ByteImage image = images.find(List.of(file), file, note -> values.note(f.get("image"), note));
    return new ImageTexture(image, layout, Optional.ofNullable(mapping));
  }

  private static final List<Double> PAIR = Collections.nCopies(2, 0.0);

  /** Returns how often an image lies along u and v: two numbers, or one for both. */
  private List<Double> scale(Fields f) {
    if (f.has("scale") && f.get("scale") instanceof Sequence) {
      return values.numbers(f.get("scale"), 2, "[along u, along v]");
    }
    return Collections.nCopies(2, f.number("scale", 1));
  }

  private Mapping mapping(YamlNode node) {
    Fields f = new Fields(node, Section.MAPPING, values);
    if (f.isSound() && f.has("planar") == f.has("spherical")) {
      values.report(node, "a mapping is either 'planar' or 'spherical'");
    }
    if (!f.isSound()) {
      return null;
    }
    return f.has("planar")
        ? planar(new Fields(f.get("planar"), Section.PLANAR, values))
        : spherical(new Fields(f.get("spherical"), Section.SPHERICAL, values));
  }

  private static Mapping planar(Fields f) {
    Vector3d corner = f.vector("corner");
    Vector3d edge1 = f.vector("edge1");
    Vector3d edge2 = f.vector("edge2");
    return f.build(() -> Planar.of(corner, edge1, edge2));
  }

  private static Mapping spherical(Fields f) {
    Vector3d center = f.vector("center");
    Vector3d up = f.has("up") ? f.vector("up") : new Vector3d(0, 1, 0);
    Vector3d front = f.has("front") ? f.vector("front") : new Vector3d(0, 0, 1);
    return f.build(() -> Spherical.of(center, up, front));
  }
}
