package glint.render;

import glint.color.Rgb;
import glint.math.BadValueException;
import glint.scene.Prepared;
import java.util.EnumSet;
import java.util.List;

/**
 * How a pixel of an image that is rendered to an error comes about; immutable.
 *
 * @param value its linear value, bit for bit that of the image
 * @param error what it claims to be off by, in display levels
 * @param rays all camera rays through the pixel and its border, in the order in which they were
 *     traced: those of its corners that others do not tell of, where edges were searched, and its
 *     samples
 */
public record PixelHistory(Rgb value, double error, List<Replay.Sample> rays) {

  /**
   * Renders the image again, on one thread, and watches the pixel.
   *
   * @throws BadValueException if the pixel is outside of the image
   */
  public static PixelHistory of(Prepared scene, RenderSettings settings, int column, int row) {
    settings.requirePixel(column, row);
    PixelWatch watch = new PixelWatch(column, row);
    RenderSettings watched =
        new RenderSettings(
            settings.width(),
            settings.height(),
            settings.goal(),
            settings.seed(),
            settings.maxDepth(),
            1,
            settings.tileSize(),
            EnumSet.of(Aov.ERROR));
    RenderResult result = new Renderer(scene, watched, watch).render(Progress.NONE);
    int at = 3 * (row * settings.width() + column);
    double[] rgb = result.image().rgb();
    double error = result.aovs().get(Aov.ERROR).rgb()[at];
    return new PixelHistory(
        new Rgb(rgb[at], rgb[at + 1], rgb[at + 2]), error, List.copyOf(watch.seen));
  }
}
