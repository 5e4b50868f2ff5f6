package glint.io;

import glint.color.Rgb;
import glint.io.YamlNode.Sequence;
import glint.optics.Checker;
import glint.optics.Stripes;
import glint.optics.Texture;
import java.util.List;

/** Reads textures. */
final class TextureReader {

  private final Values values;

  TextureReader(Values values) {
    this.values = values;
  }

  /** Makes a pattern of a size and two colours. */
  private interface Pattern {
    Texture of(double size, Rgb a, Rgb b);
  }

  /** Returns the texture, or null with its problems reported. */
  Texture read(YamlNode node) {
    Fields f = new Fields(node, Section.TEXTURE, values);
    if (f.isSound() && f.has("checker") == f.has("stripes")) {
      values.report(node, "a texture is either a 'checker' or 'stripes'");
    }
    if (!f.isSound()) {
      return null;
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
}
