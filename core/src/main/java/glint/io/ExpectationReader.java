package glint.io;

import glint.color.Rgb;
import glint.io.YamlNode.Sequence;
import glint.math.Check;
import glint.render.RenderSettings;
import glint.scene.Expectation;
import glint.scene.Scene;
import java.util.Optional;
import java.util.OptionalInt;

/** Reads what scenes say that their pictures show. */
final class ExpectationReader {

  private final Values values;

  ExpectationReader(Values values) {
    this.values = values;
  }

  /** Adds the expectation of one list item to a scene whose size is set. */
  void read(YamlNode item, Scene.Builder scene) {
    Fields f = new Fields(item, Section.EXPECTATION, values);
    boolean mean = f.means("mean");
    if (f.isSound() && (mean == f.has("pixel") || (mean && f.has("value")))) {
      values.report(item, "an expectation is either of a 'pixel' and its 'value' or of the 'mean'");
    }
    Optional<Expectation.Pixel> pixel = f.has("pixel") ? pixel(f.get("pixel")) : Optional.empty();
    Rgb value = f.has("pixel") ? f.light("value") : f.light("mean", Rgb.BLACK);
    if (f.isSound() && !f.has("tolerance") && !f.has("relative")) {
      values.report(item, "an expectation needs 'tolerance' or 'relative'");
    }
    double tolerance = f.number("tolerance", 0);
    double relative = f.number("relative", 0);
    int samples = f.wholeNumber("samples", mean ? RenderSettings.DEFAULT_SAMPLES : 1);
    int depth = f.wholeNumber("depth", 0);
    OptionalInt maxDepth = f.has("depth") ? OptionalInt.of(depth) : OptionalInt.empty();
    f.build(
        () -> {
          Check.range("samples", samples, 1, RenderSettings.MAX_SAMPLES);
          Check.range("depth", depth, 0, RenderSettings.MAX_DEPTH);
          return scene.expect(
              new Expectation(pixel, value, tolerance, relative, samples, maxDepth));
        });
  }

  private Optional<Expectation.Pixel> pixel(YamlNode node) {
    if (!(node instanceof Sequence list && list.items().size() == 2)) {
      values.wrong(node, "2 whole numbers [column, row]");
      return Optional.empty();
    }
    int column = values.wholeNumber(list.items().get(0));
    int row = values.wholeNumber(list.items().get(1));
    return Optional.of(new Expectation.Pixel(column, row));
  }
}
