package glint.report;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.image.Image;
import glint.render.RenderSettings;
import glint.scene.Expectation;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What a scene says of its own picture, taken as exact; immutable.
 *
 * @param expectations at least one, all for one depth: of pixels or of the mean
 */
public record Answers(List<Expectation> expectations, Transfer transfer) implements Truth {

  /**
   * Returns the answers of a scene to which its image tends as samples grow: pixels, or without any
   * the mean; nothing if it has neither. What is expected of a single sample is left aside, as that
   * is the light at the pixels' centres.
   */
  public static Optional<Answers> of(Scene scene) {
    List<Expectation> all = new ArrayList<>(scene.expectations());
    all.removeIf(each -> each.samples() == 1);
    if (all.stream().anyMatch(each -> each.pixel().isPresent())) {
      all.removeIf(each -> !each.pixel().isPresent());
    }
    if (all.isEmpty()) {
      return Optional.empty();
    }
    OptionalInt depth = all.get(0).maxDepth();
    all.removeIf(each -> !each.maxDepth().equals(depth));
    return Optional.of(new Answers(List.copyOf(all), scene.transfer()));
  }

  /**
   * Returns the settings under which a scene is measured: one that says anything of its picture
   * keeps its own size, and the depth of its answers.
   *
   * @param asked what to measure with otherwise
   */
  public static RenderSettings settings(Scene scene, RenderSettings asked) {
    if (scene.expectations().isEmpty()) {
      return asked;
    }
    return new RenderSettings(
        scene.width(),
        scene.height(),
        asked.samples(),
        asked.seed(),
        of(scene).map(answers -> answers.expectations.get(0).maxDepth()).orElse(asked.maxDepth()),
        asked.threads(),
        asked.tileSize(),
        asked.aovs());
  }

  /** Returns an image that is what the answers say, as a truth to compare others with. */
  public Reference reference(Image image) {
    return new Reference(image, origin(), uncertainty(), transfer);
  }

  /** Returns the whole image, if every pixel of that size has an answer. */
  public Optional<Image> image(int width, int height) {
    if (!expectations.get(0).pixel().isPresent() || expectations.size() < width * height) {
      return Optional.empty();
    }
    Image image = new Image(width, height);
    for (Expectation each : expectations) {
      Expectation.Pixel pixel = each.pixel().get();
      image.set(pixel.x(), pixel.y(), each.value().r(), each.value().g(), each.value().b());
    }
    return Optional.of(image);
  }

  @Override
  public Errors errors(Image image) {
    Errors.Sum sum = new Errors.Sum(transfer);
    for (Expectation each : expectations) {
      Rgb light = each.pixel().isPresent() ? at(each.pixel().get(), image) : mean(image);
      sum.add(light, each.value());
    }
    return sum.errors();
  }

  @Override
  public double uncertainty() {
    return 0;
  }

  @Override
  public String origin() {
    if (!expectations.get(0).pixel().isPresent()) {
      return "exact mean";
    }
    return expectations.size() == 1 ? "exact pixel" : expectations.size() + " exact pixels";
  }

  private static Rgb at(Expectation.Pixel pixel, Image image) {
    int at = 3 * (pixel.y() * image.width() + pixel.x());
    return new Rgb(image.rgb()[at], image.rgb()[at + 1], image.rgb()[at + 2]);
  }

  private static Rgb mean(Image image) {
    double[] rgb = image.rgb();
    Rgb sum = Rgb.BLACK;
    for (int i = 0; i < rgb.length; i += 3) {
      sum = sum.plus(new Rgb(rgb[i], rgb[i + 1], rgb[i + 2]));
    }
    return sum.times(3.0 / rgb.length);
  }
}
